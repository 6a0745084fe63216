// Finds for every half-edge of one sphere the half-edge that follows it, the one that starts where it ends. Several
// arcs on one circle are distinguished by the order of the mid-points of the covered arcs: a loop runs clockwise, so
// the free arc that it enters at the entry of cap R ends at the exit that comes last before R, counter-clockwise.
//
// Each circle has two words of bits. A half-edge has a bit in the word `leaving` of its own circle, and one in the word
// `arriving` of its previous circle, along which its loop arrives at the vertex where it starts. So nearly every
// half-edge finds its follower without a comparison, and the cyclic order decides among the candidates that are left.
// As every half-edge follows exactly one other, a follower that is found is no candidate any more. If there are more
// half-edges than bits, the words are the heads of lists.
#pragma once

#include "core/id_range.hpp"
#include "core/workspace.hpp"
#include "exact/angular_order.hpp"

namespace hsp {

class HalfEdgeChain {
 public:
  HalfEdgeChain() = default;
  // Two words for each circle; the numbers of the circles are below the size of the arrays. All words are 0 between
  // calls.
  HalfEdgeChain(Span<uint32_t> arriving, Span<uint32_t> leaving)
      : HalfEdgeChain(arriving, leaving, {0, arriving.size()}) {}
  // The same, for circles with numbers in a range alone.
  HalfEdgeChain(Span<uint32_t> arriving, Span<uint32_t> leaving, IdRange circles)
      : arriving_(arriving), leaving_(leaving) {
    for (uint32_t &word : arriving_.part(circles.first, circles.last)) word = 0;
    for (uint32_t &word : leaving_.part(circles.first, circles.last)) word = 0;
  }

  // Stores in each half-edge the number of its follower; the first half-edge has the number `first`. `previous` is the
  // member with the circle of the half-edge that ends where this one starts, direction(c) the normal of the plane of
  // circle c. O(n), except that on a circle with several arcs each half-edge looks at all arcs of the circle.
  template <class Item, class Direction>
  void link(Span<Item> half_edges, uint32_t first, uint32_t Item::*previous, Direction direction) const {
    if (half_edges.size() <= most) {
      for (uint32_t k = 0; k < half_edges.size(); ++k) mark(half_edges[k].*previous, half_edges[k].circle, k);
      return link_marked(half_edges, first, previous, direction);
    }
    link_lists(half_edges, first, previous, direction);
  }

  // The same in two steps, for at most `most` half-edges: all are marked first, in any order, then linked. The sum of
  // the values that mark() returns is the number of circles.
  static constexpr uint32_t most = 32;
  uint32_t mark(uint32_t previous_circle, uint32_t circle, uint32_t k) const {
    const uint32_t bit = UINT32_C(1) << k;
    const uint32_t others = arriving_[previous_circle];
    arriving_[previous_circle] = others | bit;
    leaving_[circle] |= bit;
    return static_cast<uint32_t>(others == 0);
  }
  template <class Item, class Direction>
  void link_marked(Span<Item> half_edges, uint32_t first, uint32_t Item::*previous, Direction direction) const {
    // Half-edges with one candidate alone come first: no branch depends on them, and their followers are no candidates
    // for the others.
    uint32_t open = 0;
    for (uint32_t k = 0; k < half_edges.size(); ++k) {
      Item &half_edge = half_edges[k];
      const uint32_t left = candidates(half_edge.circle, half_edge.*previous);
      const uint32_t lowest = left & (0 - left);
      const uint32_t is_open = static_cast<uint32_t>(left != lowest);
      half_edge.next = first + lowest_of(left);
      arriving_[half_edge.circle] ^= lowest & (is_open - 1);
      open |= is_open << k;
    }
    for (; open != 0; open &= open - 1) {
      Item &half_edge = half_edges[lowest_of(open)];
      const uint32_t left = candidates(half_edge.circle, half_edge.*previous);
      const uint32_t best = first_of(half_edges, half_edge.circle, half_edge.*previous, left, direction);
      arriving_[half_edge.circle] ^= UINT32_C(1) << best;
      half_edge.next = first + best;
    }
    for (const Item &half_edge : half_edges) leaving_[half_edge.circle] = 0;
  }
  // Instead of linking: sets the words of marked half-edges to 0 again.
  template <class Item>
  void unmark(Span<Item> half_edges, uint32_t Item::*previous) const {
    for (const Item &half_edge : half_edges) arriving_[half_edge.*previous] = leaving_[half_edge.circle] = 0;
  }

 private:
  // The half-edges that arrive along one circle are a list: it begins in the circle's word and goes on in `next`, each
  // number increased by 1. While the lists are needed, followers are stored in place of the previous circles. At the
  // end these are restored from the followers.
  template <class Item, class Direction>
  void link_lists(Span<Item> half_edges, uint32_t first, uint32_t Item::*previous, Direction direction) const {
    for (uint32_t k = 0; k < half_edges.size(); ++k) {
      uint32_t &head = arriving_[half_edges[k].*previous];
      half_edges[k].next = head;
      head = k + 1;
    }
    for (Item &half_edge : half_edges) {
      const exact::Vector axis = direction(half_edge.circle);
      const uint32_t from = half_edge.*previous, list = arriving_[half_edge.circle];
      uint32_t best = list;
      for (uint32_t other = half_edges[list - 1].next; other != 0; other = half_edges[other - 1].next) {
        const uint32_t nearest = half_edges[best - 1].circle, circle = half_edges[other - 1].circle;
        if (circle == from) continue;  // a whole turn away
        if (nearest == from ||
            exact::counter_clockwise_before(axis, direction(from), direction(nearest), direction(circle))) {
          best = other;
        }
      }
      half_edge.*previous = best - 1;
    }
    for (Item &half_edge : half_edges) {
      arriving_[half_edge.circle] = 0;
      half_edge.next = half_edge.*previous;
    }
    for (Item &half_edge : half_edges) {
      half_edges[half_edge.next].*previous = half_edge.circle;
      half_edge.next += first;
    }
  }

  static uint32_t lowest_of(uint32_t bits) { return static_cast<uint32_t>(__builtin_ctz(bits)); }

  // The candidates to follow a half-edge. One that leaves along the half-edge's previous circle is a whole turn away:
  // it is a candidate only if there is no other.
  uint32_t candidates(uint32_t circle, uint32_t previous_circle) const {
    const uint32_t all = arriving_[circle];
    const uint32_t nearer = all & ~leaving_[previous_circle];
    return nearer | (all & (0 - static_cast<uint32_t>(nearer == 0)));
  }

  template <class Item, class Direction>
  static uint32_t first_of(Span<Item> half_edges, uint32_t circle, uint32_t previous_circle, uint32_t left,
                           Direction direction) {
    uint32_t best = lowest_of(left);
    left &= left - 1;
    if (left == 0) return best;
    const exact::TurningOrder order(direction(circle), direction(previous_circle));
    for (; left != 0; left &= left - 1) {
      const uint32_t other = lowest_of(left);
      if (order.before(direction(half_edges[best].circle), direction(half_edges[other].circle))) best = other;
    }
    return best;
  }

  Span<uint32_t> arriving_, leaving_;
};

}  // namespace hsp
