// The half-edge that follows another one, by a look at each: what HalfEdgeChain finds for all at once.
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"
#include "exact/angular_order.hpp"

namespace support {

// The index, among the half-edges of one sphere, of the half-edge that follows `half_edge`: it starts where `half_edge`
// ends. previous(h) is the circle of the half-edge that ends where h starts, and direction(c) the normal of the plane
// of circle c.
template <class Item, class Previous, class Direction>
uint32_t find_next(hsp::Span<Item> half_edges, const Item &half_edge, Previous previous, Direction direction) {
  uint32_t best = hsp::no_id;
  for (uint32_t w = 0; w < half_edges.size(); ++w) {
    const Item &candidate = half_edges[w];
    if (previous(candidate) != half_edge.circle) continue;
    if (best == hsp::no_id || half_edges[best].circle == previous(half_edge)) {
      best = w;
      continue;
    }
    if (candidate.circle == previous(half_edge)) continue;  // a whole turn away
    if (hsp::exact::counter_clockwise_before(direction(half_edge.circle), direction(previous(half_edge)),
                                             direction(half_edges[best].circle), direction(candidate.circle))) {
      best = w;
    }
  }
  return best;
}

}  // namespace support
