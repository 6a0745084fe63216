// Where the arcs of a ball's loops end.
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"
#include "exact/angular_order.hpp"

namespace hsp {

// Among the uses of one ball, the index of the one at which the arc ends that starts at `use`. direction(c) is the
// normal of the plane whose circle uses name c. Several arcs on one circle are told apart by the order of the
// mid-points of the covered arcs: the free arc that a loop walks backwards from entry R ends at the exit that comes
// last before R, counter-clockwise.
template <class Use, class Direction>
uint32_t end_of_arc(Span<Use> uses, const Use &use, Direction direction) {
  uint32_t best = no_id;
  for (uint32_t w = 0; w < uses.size(); ++w) {
    const Use &candidate = uses[w];
    if (candidate.in != use.out) continue;
    if (best == no_id || uses[best].out == use.in) {
      best = w;
      continue;
    }
    if (candidate.out == use.in) continue;  // a whole turn away
    if (exact::counter_clockwise_before(direction(use.out), direction(use.in), direction(uses[best].out),
                                        direction(candidate.out))) {
      best = w;
    }
  }
  return best;
}

}  // namespace hsp
