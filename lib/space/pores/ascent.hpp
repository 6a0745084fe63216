// A way up from any point to where f has a maximum, in doubles.
//
// With a_i the unit vectors from the centres to a point, d a unit vector with d.a_i >= s for all balls within delta of
// the nearest one, and h = delta / (1 + s): along d each of them gets farther by s h at least, since |x - c| is convex,
// and no other ball gets nearer by more than h. So f rises by s h, and is nowhere on the way below where it began. d is
// that of the point of the hull of the a_i that is nearest to 0. Where s is small delta is halved, down to a fraction
// of a lattice step: at a maximum, or beside a gate or the middle of a gap of two balls, from where the way goes on at
// right angles to their directions.
//
// Where more balls are within a short delta than there is room for, as along the axis of a ring that ties nearly, none
// is kept: each pass looks at all balls around once more.
//
// Where steps gain no more than rounding takes, as on a ridge of millionths of a step between near ties, f does not
// rise over many of them. The way ends there, unless it is so far from all balls that rounding takes whole steps.
#pragma once

#include <limits>

#include "core/extremes.hpp"
#include "core/fixed_vector.hpp"
#include "pores/balls_around.hpp"
#include "pores/pores.hpp"

namespace hsp {

class Ascent {
 public:
  // From a point in no ball, or in one.
  Ascent(const BallsAround &balls, const exact::Vector &start);

  // f there, and where it is, seen from the start.
  double level() const { return level_; }
  const Vec3 &offset() const { return at_; }
  // Whether level() is f where the way is; else it is less, as it is too far from all balls.
  bool level_is_known() const { return known_ >= 0.0 || crowd_ >= 0.0; }
  // A ball that is nearest there; no_id without balls.
  NearImage nearest_ball() const { return nearest_; }
  // Beyond the box around all centres: from there f rises for ever. Never in a periodic box.
  bool is_outside() const { return outside_; }
  // One step up. False if there is none, or outside, or if steps lead nowhere.
  bool step();
  // Whether a step began at a gate or in the middle of a gap, where the way might have led to the other side as well.
  bool has_left_saddle() const { return saddles_ > 0; }
  // Whether steps were given up, which cannot happen.
  bool is_lost() const { return steps_ == most_steps; }

 private:
  static constexpr uint32_t room = 64;
  static constexpr uint32_t room_of_ties = 96;  // of near ties, as of a ring of balls, of which a few lead nowhere
  static constexpr uint32_t most_steps = 100000;
  static constexpr uint32_t stretch = 1024;  // so many steps do not lead on if f is no larger after them
  static constexpr double far = 0x1p34;
  struct NearBall {
    Vec3 a;  // unit vector from the centre
    double gap;
  };

  bool look(double reach);
  uint32_t within(double delta);
  // Not inlined: ways up are deep in the stack, and these are not where the most of it is used.
  [[gnu::noinline]] uint32_t count_crowd(double delta, double highest);
  template <class Sink>
  [[gnu::noinline]] void visit_around(double reach, Sink sink) const;
  template <class Sink>
  void visit_near(uint32_t count, Sink sink) const;
  uint32_t choose_tied(uint32_t count, Vec3 *a) const;
  NearBall seen(const NearImage &image) const;
  Vec3 lead_of(uint32_t count) const;
  double size() const { return std::fabs(level_) + static_cast<double>(balls_.set().largest_radius) + 1.0; }
  // No shorter steps are taken: a fraction of a lattice step, or what doubles know of a way so long.
  double least_delta() const {
    return larger_of(0x1p-6, 0x1p-50 * (size() + std::fabs(at_.x) + std::fabs(at_.y) + std::fabs(at_.z)));
  }
  // How far the distances of balls that tie at a saddle may differ where a way stops beside it.
  double tie_reach() const { return smaller_of(16.0, 0x1p-6 * size()); }
  bool leave_saddle(double slack);
  bool leave_along(const Vec3 &n, double slack);
  void move(double length, const Vec3 &direction);

  BallsAround balls_;
  exact::Vector start_;
  Vec3 at_{0.0, 0.0, 0.0};
  double level_ = 0.0;
  double delta_ = 0.0;           // of the next try
  double known_ = -1.0;          // near_ has all balls within that of the nearest one; below 0: none
  double crowd_ = -1.0;          // near_ has the nearest one alone of the many within that; below 0: it is as above
  NearBall near_[room_of_ties];  // the nearest one first
  uint32_t near_count_ = 0, room_ = room;
  NearImage nearest_{no_id, {}};
  uint32_t saddles_ = 0;  // that were left
  uint32_t steps_ = 0;
  double before_stretch_ = -std::numeric_limits<double>::infinity();  // f
  bool outside_ = false, ended_ = false;
};

// The point of the hull of two to four points that is nearest to 0. Of the points those stay that span it. The last one
// is new: the others are one, or have stayed, and of_others is what was returned for them.
Vec3 nearest_to_zero(Vec3 *points, uint32_t &count, const Vec3 &of_others);

}  // namespace hsp
