// Which half-edge of one sphere follows which: half_edges.hpp's find_next() for all at once. Half-edges that arrive at
// a vertex along one circle, and those that leave along it, are bits of words that belong to the circle. So nearly
// every half-edge finds its follower without a comparison, and the cyclic order decides between what is left.
#pragma once

#include <bit>

#include "core/workspace.hpp"
#include "sphere/half_edges.hpp"

namespace hsp {

class HalfEdgeChain {
 public:
  HalfEdgeChain() = default;
  // Words for circles with numbers below their size; 0 between calls.
  HalfEdgeChain(Span<uint32_t> arriving, Span<uint32_t> leaving) : arriving_(arriving), leaving_(leaving) {
    for (uint32_t &word : arriving_) word = 0;
    for (uint32_t &word : leaving_) word = 0;
  }

  // Stores in each half-edge the number of its follower, the first of them being number `first`. direction(c) is the
  // normal of the plane of circle c.
  template <class Direction>
  void link(Span<HalfEdge> half_edges, uint32_t first, Direction direction) const {
    const uint32_t count = half_edges.size();
    if (count > most) {
      for (HalfEdge &half_edge : half_edges) half_edge.next = first + find_next(half_edges, half_edge, direction);
      return;
    }
    for (uint32_t k = 0; k < count; ++k) {
      arriving_[half_edges[k].previous_circle] |= UINT32_C(1) << k;
      leaving_[half_edges[k].circle] |= UINT32_C(1) << k;
    }
    for (HalfEdge &half_edge : half_edges) {
      // A follower that leaves along the circle before this one is a whole turn away: it is the last.
      const uint32_t all = arriving_[half_edge.circle];
      const uint32_t nearer = all & ~leaving_[half_edge.previous_circle];
      uint32_t left = nearer != 0 ? nearer : all;
      uint32_t best = static_cast<uint32_t>(std::countr_zero(left));
      left &= left - 1;
      if (left != 0) best = first_of(half_edges, half_edge, best, left, direction);
      half_edge.next = first + best;
    }
    for (const HalfEdge &half_edge : half_edges) arriving_[half_edge.previous_circle] = leaving_[half_edge.circle] = 0;
  }

 private:
  static constexpr uint32_t most = 32;

  template <class Direction>
  static uint32_t first_of(Span<const HalfEdge> half_edges, const HalfEdge &half_edge, uint32_t best, uint32_t others,
                           Direction direction) {
    const exact::TurningOrder order(direction(half_edge.circle), direction(half_edge.previous_circle));
    for (; others != 0; others &= others - 1) {
      const uint32_t other = static_cast<uint32_t>(std::countr_zero(others));
      if (order.before(direction(half_edges[best].circle), direction(half_edges[other].circle))) best = other;
    }
    return best;
  }

  Span<uint32_t> arriving_, leaving_;
};

}  // namespace hsp
