// The caps of one ball: the parts of its sphere that lie inside other balls (Step 1 of Section 4.2). A cap is kept as
//   u, b    in doubles: a point x of the unit sphere lies in the cap iff u.x >= b, with u the unit vector to the other
//           centre. |u error| <= 3.5e, |b error| <= 7e (e = 2^-53), as U = |v|^2, h and r are exact integers:
//           sqrt(U) 1.5e, its inverse 2.5e, u one more; h 1e, times the inverse 4.5e, times 1/(2r) 6.5e;
//   ball    the other ball. The exact stage, which is seldom needed, makes the exact half-space of exact/ from it.
#pragma once

#include "core/disjoint_sets.hpp"
#include "core/workspace.hpp"
#include "exact/predicates.hpp"
#include "model/cube_grid.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

// For kernels.
inline BallArrays arrays_of(const BallSet &balls) {
  return {balls.x.data(), balls.y.data(), balls.z.data(), balls.r.data(), balls.words()};
}

// Whether ball `inner` lies inside ball `outer`. A ball does not lie inside itself.
bool lies_inside(const BallSet &balls, uint32_t inner, uint32_t outer);

// Moves the selected ones of the first `earlier` balls to the front, and the entries of further arrays with them.
// Returns how many balls are selected. selected: an entry for each ball of the set, 0 if it is not selected.
template <class... Rest>
uint32_t put_selected_first(uint32_t earlier, const uint32_t *selected, Span<uint32_t> ball, Rest... rest) {
  uint32_t first = 0;
  const auto exchange = [&](auto array, uint32_t k) {
    const auto moved = array[first];
    array[first] = array[k];
    array[k] = moved;
  };
  for (uint32_t k = 0; k < earlier; ++k) {
    if (selected[ball[k]] == 0) continue;
    exchange(ball, k);
    (exchange(rest, k), ...);
    ++first;
  }
  return first;
}

// The class of a cap by its size, from 0 for the largest caps to classes - 1 for the smallest. b runs from -1 (the
// whole sphere) to 1 (nothing); NaN is in the last class.
inline uint32_t size_class(double b, uint32_t classes) {
  const double scaled = (b + 1.0) * (0.5 * classes);
  if (!(scaled < classes)) return classes - 1;
  return scaled > 0.0 ? static_cast<uint32_t>(scaled) : 0;
}

// Caps in ascending order of the grid's ball ids: a structure of arrays over scratch memory of fixed capacity.
struct Caps {
  static constexpr uint32_t padding = has_lanes ? 8 : 0;  // entries behind the spare slot that may be written
  // All arrays have a spare slot behind the last cap.
  Span<double> ux, uy, uz, b;
  Span<uint32_t> ball;  // the other ball, grid order
  uint32_t count = 0;
  // The first later cap. Later caps are those of balls after the origin ball in grid order. If only selected balls are
  // searched, they are these caps and those of all balls that are not selected.
  uint32_t first_later = 0;

  uint32_t origin = 0;  // the ball on which the caps lie, grid order
  exact::Sphere sphere{};
  double length_squared = 0.0;  // max(W, |v|^2), for the exact filter
  bool contained = false;       // the ball lies inside another one and has no caps that matter
  uint32_t met = 0;             // balls that meet this one, whether or not there was room for their caps
  bool lanes = false;           // caps are made and searched in lanes if possible; the results are the same
  Target target = Target::baseline;

  void carve(Workspace &workspace, uint32_t capacity);
  uint32_t capacity() const { return ball.size() - 1 - padding; }
  bool overflowed() const { return met > capacity(); }

  // Finds the caps of ball i, whose neighbours lie in the block. Joins every ball that meets ball i to it in
  // `components`, unless that is null.
  void gather(const BallSet &balls, const CubeBlock &block, uint32_t i, DisjointSets *components);

  // Finds the caps of ball i by n other balls alone, which the caller has put into `ball`, in any order; none of them
  // is certainly disjoint from ball i. If all n are later balls, first_later is 0; else it means nothing.
  void gather_given(const BallSet &balls, uint32_t i, uint32_t n);

  // The same as gather(), but without ux, uy, uz and b. The caller has put the n balls into `ball`, of which n_earlier
  // are not later ones; all certainly meet ball i in proper circles. make_doubles() makes the rest, once, if needed.
  void take_circles(const BallSet &balls, uint32_t i, uint32_t n, uint32_t n_earlier, DisjointSets *components);
  void make_doubles();
  // Writes the doubles of the caps with these numbers to other arrays, but not `to.ball`. At most most_at_once numbers
  // are given. Returns how many are made: it stops before a cap that is not certain to be a proper circle.
  static constexpr uint32_t most_at_once = 32;
  uint32_t make_doubles_of(Span<const uint32_t> numbers, const CapArrays &to) const;

  // The normal of a cap's plane: the vector from the origin ball's centre to the other centre.
  exact::Vector direction(uint32_t k) const;
  exact::Plane plane(uint32_t k) const;
  exact::Plane plane_of_ball(uint32_t other) const;  // other: the ball of a cap

  // Stores a great circle of the sphere in the spare slot, number `count`, for cap_pair.hpp. It has the error bounds of
  // caps, as its normal is exact.
  void set_spare_great_circle(const exact::Vector &normal);
  // Adds the half of the sphere on the side of the normal as a cap of ball no_id (the far side of a view); at most one.
  void add_half_sphere(const exact::Vector &normal);

  // After gather(): moves the selected earlier balls to the front; all caps behind them become later caps.
  void put_selected_first(const uint32_t *selected);

  // Drops the caps of balls that keep(ball) refuses.
  template <class Keep>
  void keep_if(Keep keep) {
    uint32_t kept = 0, later = 0;
    for (uint32_t k = 0; k < count; ++k) {
      if (keep(ball[k])) move_to(kept, k, later);
    }
    count = kept;
    first_later = later;
  }
  // Drops all caps but those with these numbers, which are ascending.
  void keep(Span<const uint32_t> numbers) {
    uint32_t kept = 0, later = 0;
    for (const uint32_t k : numbers) move_to(kept, k, later);
    count = kept;
    first_later = later;
  }

  const BallSet &balls() const { return *balls_; }
  Vec3 axis(uint32_t k) const { return {ux[k], uy[k], uz[k]}; }
  exact::Predicates predicates() const { return {sphere, length_squared}; }
  // Index of the cap of a ball. There must be one, and the caps must be in grid order.
  uint32_t cap_of(uint32_t other) const;

 private:
  class Joining;
  struct Distance;

  void move_to(uint32_t &kept, uint32_t k, uint32_t &later) {
    ux[kept] = ux[k];
    uy[kept] = uy[k];
    uz[kept] = uz[k];
    b[kept] = b[k];
    ball[kept++] = ball[k];
    if (k < first_later) later = kept;
  }
  void start(const BallSet &balls, uint32_t i);
  bool take(const exact::LatticeBall &own, uint32_t j, const Distance &distance, Joining &joining);
  bool take_each(const uint32_t *near, uint32_t n, Joining &joining);
  template <bool ranked>
  void take_given(uint32_t n, Joining &joining);
  void gather_in_lanes(const CubeBlock &block, Joining &joining);
  bool take_near(Span<uint32_t> near, Joining &joining);
  template <bool ranked>
  bool take_all(uint32_t *near, uint32_t hits, Joining &joining);
  const BallSet *balls_ = nullptr;  // the set of the origin ball
  exact::Plane half_sphere_{};      // the plane of ball no_id
};

}  // namespace hsp
