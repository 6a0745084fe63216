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
  // The number of arcs on these circles; and of their saddles, one for each arc and for each circle that is free as a
  // whole, also if there is no room for all.
  uint32_t arcs() const { return arcs_; }
  uint32_t saddles() const { return arcs_ + (clamped_count(required()) - first_whole_); }

  // The number of a circle with arcs, by its two balls, or of a circle that is free as a whole; no_id if it has no
  // cusps.
  uint32_t of_arc(uint32_t a, uint32_t b) const;
  uint32_t of_circle(uint32_t circle) const;
  // Whether the first element on ball 0 of circle k is this one; false if there is no circle k.
  bool begins_with(uint32_t k, LoopElement element) const { return k < count() && circle_[k].element == element; }
  // Saddles of these circles have consecutive numbers, those of arcs first. The number of a saddle from its element on
  // ball 0 of circle k, and that element from the number.
  uint32_t saddle_number(uint32_t k, LoopElement element) const {
    return circle_[k].first_saddle + (element.code() - circle_[k].element.code());
  }
  LoopElement element(uint32_t saddle_number) const;
  uint32_t first_whole() const { return first_whole_; }
  // Those on ball 0 of circle k, which have consecutive ids; none if it is free as a whole.
  IdRange half_edges(uint32_t k) const {
    if (k >= first_whole_) return {};
    const uint32_t first = circle_[k].element.half_edge();
    const uint32_t behind = k + 1 < count() ? circle_[k + 1].first_saddle : arcs_;
    return {first, first + (behind - circle_[k].first_saddle)};
  }
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
    LoopElement element;    // the first half-edge of this circle on ball[0], or the circle
    uint32_t first_saddle;  // number of saddles of the circles before
  };

  FixedVector<Circle> circle_;  // those with arcs by their first ball, then those free as a whole by their ids
  uint32_t first_whole_ = 0;
  uint32_t arcs_ = 0;
};

}  // namespace hsp
