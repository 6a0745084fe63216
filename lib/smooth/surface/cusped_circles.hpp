// Circles whose saddle patches reach their own axis (saddle.hpp). All arcs of such a circle share its two cusps.
#pragma once

#include "core/patience.hpp"
#include "core/workspace.hpp"
#include "surface/actual_balls.hpp"

namespace hsp {

class CuspedCircles {
 public:
  // For at most so many circles.
  void carve(Workspace &workspace, uint32_t circles) { circle_ = FixedVector(workspace.take<Circle>(circles)); }
  void clear();
  // False if `patience` stops it.
  bool find(const ActualBalls &actual, Patience &patience);

  // The number of circles, also if there is no room for all.
  uint64_t required() const { return circle_.required(); }
  uint32_t count() const { return circle_.size(); }
  // The number of arcs on these circles, and of those circles that are free as a whole.
  uint32_t arcs() const { return arcs_; }
  uint32_t whole_circles() const { return clamped_count(required()) - first_whole_; }

  // The number of a circle with arcs, by its two balls, or of a circle that is free as a whole; no_id if it has no
  // cusps.
  uint32_t of_arc(uint32_t a, uint32_t b) const;
  uint32_t of_circle(uint32_t circle) const;
  // Whether circle k is that of two balls a < b with arcs, or this one that is free as a whole; false if there is no
  // circle k.
  bool is_of_arc(uint32_t k, uint32_t a, uint32_t b) const {
    return k < first_whole_ && circle_[k].ball[0] == a && circle_[k].ball[1] == b;
  }
  bool is_of_circle(uint32_t k, uint32_t circle) const {
    return k >= first_whole_ && k < count() && circle_[k].element == circle;
  }
  // Arcs on these circles have consecutive numbers. The number of an arc from its half-edge on ball 0 of circle k, and
  // that half-edge from the number.
  uint32_t arc_number(uint32_t k, uint32_t half_edge) const {
    return circle_[k].first_arc + (half_edge - circle_[k].element);
  }
  uint32_t half_edge(uint32_t arc_number) const;
  uint32_t first_whole() const { return first_whole_; }
  // half_edges: those on ball 0 of circle k, which have consecutive ids; none if it is free as a whole. whole_circle:
  // the id of such a circle in the boundary.
  IdRange half_edges(uint32_t k) const {
    const uint32_t first = circle_[k].element, behind = k + 1 < count() ? circle_[k + 1].first_arc : arcs_;
    return {first, first + (behind - circle_[k].first_arc)};
  }
  uint32_t whole_circle(uint32_t k) const { return circle_[k].element; }
  // The number 2 k + s of the cusp of the circle of balls a and b on the side of ball `at`; no_id if the circle has
  // none.
  uint32_t cusp(uint32_t a, uint32_t b, uint32_t at) const {
    const uint32_t k = of_arc(a, b);
    return k == no_id ? no_id : 2 * k + (at == ball(k, 1) ? 1 : 0);
  }
  // Ball 0 or 1 of circle k, in ascending order.
  uint32_t ball(uint32_t k, uint32_t side) const { return circle_[k].ball[side]; }

 private:
  struct Circle {
    uint32_t ball[2];
    uint32_t element;    // the first half-edge of this circle on ball[0], or the circle
    uint32_t first_arc;  // number of arcs on the circles before
  };

  FixedVector<Circle> circle_;  // those with arcs by their first ball, then those free as a whole by their ids
  uint32_t first_whole_ = 0;
  uint32_t arcs_ = 0;
};

}  // namespace hsp
