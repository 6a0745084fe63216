// A way up from any point to a maximum of f, the distance to the balls (pores.hpp), in doubles.
//
// One step: let a_i be the unit vectors from the centres to the point, and d a unit vector with d.a_i >= s > 0 for all
// balls within delta of the nearest one. The way goes h = delta / (1 + s) along d. Each of these balls gets farther by
// s h at least, since |x - c| is convex. Any other ball gets nearer by h at most, and delta - h = s h. So f rises by
// s h, and nowhere on the way is it below its value at the beginning. d is the direction of the point of the convex
// hull of the a_i that is nearest to 0. If s is small, delta is halved, down to a fraction of a lattice step. That
// happens at a maximum, beside a gate, and beside the middle of a gap between two balls. From a gate or such a middle
// the way goes on at right angles to the directions of the balls.
//
// More balls may be within a short delta than there is room for, as along the axis of a ring of balls that nearly tie.
// Then none of them is kept: each pass looks at all balls around once more.
//
// Rounding may take all that steps gain, as on a ridge of millionths of a step between near ties. Then f does not rise
// over many steps, and the way ends, unless it is so far from all balls that rounding takes whole lattice steps.
#pragma once

#include <limits>

#include "core/extremes.hpp"
#include "core/fixed_vector.hpp"
#include "pores/balls_around.hpp"
#include "pores/pores.hpp"

namespace hsp {

class Ascent {
 public:
  // From any point, inside balls or outside all of them.
  Ascent(const BallsAround &balls, const exact::Vector &start);

  // f where the way is, and that point relative to the start, in lattice steps.
  double level() const { return level_; }
  const Vec3 &offset() const { return at_; }
  // Whether level() is f where the way is. Else it is a lower bound of f: all balls are too far away to be found.
  bool level_is_known() const { return known_ >= 0.0 || crowd_ >= 0.0; }
  // A ball that is nearest to where the way is; no_id without balls.
  NearImage nearest_ball() const { return nearest_; }
  // Whether the way is beyond the box around all centres: from there f rises for ever. Never in a periodic box.
  bool is_outside() const { return outside_; }
  // Goes one step up. False if there is no way up, if the way is outside, or if steps lead nowhere.
  bool step();
  // Whether a step began at a gate or in the middle of a gap: there the way might as well have led to the other side.
  bool has_left_saddle() const { return saddles_ > 0; }
  // Whether steps were given up, which cannot happen.
  bool is_lost() const { return steps_ == most_steps; }

 private:
  static constexpr uint32_t room = 64;
  static constexpr uint32_t room_of_ties = 96;  // for near ties, as of a ring of balls, a few of which lead nowhere
  static constexpr uint32_t most_steps = 100000;
  static constexpr uint32_t stretch = 1024;  // if f is no larger after so many steps, steps lead nowhere
  static constexpr double far = 0x1p34;
  struct NearBall {
    Vec3 a;  // unit vector from the centre
    double gap;
  };

  bool look(double reach);
  uint32_t within(double delta);
  // Not inlined: ways up are deep in the stack, and the most stack is used in other functions.
  [[gnu::noinline]] uint32_t count_crowd(double delta, double highest);
  template <class Sink>
  [[gnu::noinline]] void visit_around(double reach, Sink sink) const;
  template <class Sink>
  void visit_near(uint32_t count, Sink sink) const;
  uint32_t choose_tied(uint32_t count, Vec3 *a) const;
  NearBall seen(const NearImage &image) const;
  Vec3 lead_of(uint32_t count) const;
  double size() const { return std::fabs(level_) + static_cast<double>(balls_.set().largest_radius) + 1.0; }
  // Steps are not shorter than that: a fraction of a lattice step, or how exactly doubles know a point so far away.
  double least_delta() const {
    return larger_of(0x1p-6, 0x1p-50 * (size() + std::fabs(at_.x) + std::fabs(at_.y) + std::fabs(at_.z)));
  }
  // A way stops beside a saddle, not on it. Up to so much the distances of balls that tie at the saddle may differ
  // there.
  double tie_reach() const { return smaller_of(16.0, 0x1p-6 * size()); }
  bool leave_saddle(double slack);
  bool leave_along(const Vec3 &n, double slack);
  void move(double length, const Vec3 &direction);

  BallsAround balls_;
  exact::Vector start_;
  Vec3 at_{0.0, 0.0, 0.0};
  double level_ = 0.0;
  double delta_ = 0.0;           // of the next try
  double known_ = -1.0;          // near_ has all balls within known_ of the nearest one; below 0: it has none
  double crowd_ = -1.0;          // not below 0: near_ has the nearest ball alone, of many that are within crowd_ of it
  NearBall near_[room_of_ties];  // the nearest one first
  uint32_t near_count_ = 0, room_ = room;
  NearImage nearest_{no_id, {}};
  uint32_t saddles_ = 0;  // how many were left
  uint32_t steps_ = 0;
  double before_stretch_ = -std::numeric_limits<double>::infinity();  // f at the end of the last `stretch` steps
  bool outside_ = false, ended_ = false;
};

// The point of the convex hull of two to four points that is nearest to 0. Only the points that span it stay in
// `points`. The last point is new. of_others: the point of the hull of the others nearest to 0, as the call before has
// returned it; or the other point, if it is one.
Vec3 nearest_to_zero(Vec3 *points, uint32_t &count, const Vec3 &of_others);

}  // namespace hsp
