// The balls on their lattice. Coordinates and radii are integers stored in doubles (exact below 2^53), because the hot
// loops subtract and square them; the exact predicates get them as int64.
//
// As an example a step of 1e-3 and a probe of 1.4: the caller's ball of radius 1.7 at (0.5, -1.25, 2) has x = 500, y =
// -1250, z = 2000 and r = 1700 + 1400 = 3100.
#pragma once

#include "core/small_code.hpp"
#include "core/span.hpp"
#include "core/status.hpp"
#include "core/vec3.hpp"
#include "core/workspace.hpp"
#include "exact/lattice.hpp"
#include "exact/lattice_ball.hpp"
#include "lanes/target.hpp"

namespace hsp {

// The caller's arrays and options, by reference.
struct BallInput {
  uint32_t n = 0;
  const double *xyz = nullptr;     // [n][3]
  const double *radius = nullptr;  // [n]
  double probe = 0.0;
  double step = 0.0;            // 0: chosen by the largest radius, or for points by the largest coordinate
  double largest_radius = 0.0;  // without probe; 0: the largest of `radius`
  double extent = 0.0;          // the step is chosen as if a coordinate were as large (as those of images in a box)
};

// Puts ball i on a lattice; Status::range or Status::not_finite if it does not fit. `radius` is finite and >= 0.
Status round_ball(const exact::Lattice &lattice, int64_t probe_steps, const double *xyz, double radius, uint32_t i,
                  exact::LatticeBall &ball);

// The smallest box around some centres.
struct LatticeBox {
  exact::Vector low{}, high{};
};

inline constexpr int64_t no_radius = -1;

// Rounds the balls of an input to their lattice one at a time, so that no second copy of the set is needed.
class BallRounding {
 public:
  // Checks probe, step and all radii, and chooses the lattice. first_bad: the offending ball, or no_id.
  Status prepare(const BallInput &input, uint32_t &first_bad);
  // After prepare(), for one ball or more: checks that all balls fit the lattice, and finds the box around their
  // centres. Then round() succeeds for all balls. first_bad: on failure, the first ball that does not fit.
  Status find_box(LatticeBox &box, uint32_t &first_bad) const;
  // Begins to read ball i of the input from memory.
  void fetch(uint32_t i) const {
    const double *const xyz = input_.xyz + 3 * static_cast<size_t>(i);
    __builtin_prefetch(xyz);
    __builtin_prefetch(xyz + 2);  // which may be in another line
    __builtin_prefetch(input_.radius + i);
  }
  // Ball i of the input on the lattice.
  Status round(uint32_t i, exact::LatticeBall &ball) const {
    return round_ball(lattice_, probe_steps_, input_.xyz + 3 * static_cast<size_t>(i), input_.radius[i], i, ball);
  }
  // The centre of a ball that is known to fit the lattice, and the ball.
  HSP_INLINE_UNLESS_SMALL exact::Vector centre(uint32_t i) const {
    const double *const xyz = input_.xyz + 3 * static_cast<size_t>(i);
    return {nearest(lattice_.steps(xyz[0])), nearest(lattice_.steps(xyz[1])), nearest(lattice_.steps(xyz[2]))};
  }
  exact::LatticeBall ball(uint32_t i) const { return {centre(i), rounded_radius(input_.radius[i]), i}; }
  // The largest of all radii, probe included, if all balls fit the lattice and there are any.
  int64_t largest_radius() const { return rounded_radius(largest_); }
  // The smallest of the radii that are above 0 before they are rounded, probe included; no_radius if there is none.
  int64_t smallest_radius() const { return smallest_ < 0.0 ? no_radius : rounded_radius(smallest_); }

  const exact::Lattice &lattice() const { return lattice_; }
  int64_t probe_steps() const { return probe_steps_; }
  // BallInput::largest_radius, probe included; the probe alone if that is 0.
  int64_t expected_radius() const { return expected_radius_; }

 private:
  int64_t rounded_radius(double radius) const { return nearest(lattice_.steps(radius)) + probe_steps_; }
  bool radius_fits(double radius) const;
  // Whether a radius that is larger than BallInput::largest_radius is no larger once both are on the lattice.
  bool is_expected(double radius) const;
  double largest_coordinate() const;

  BallInput input_;
  exact::Lattice lattice_;
  double largest_ = 0.0;    // the largest radius of the input
  double smallest_ = -1.0;  // the smallest radius that is above 0 with the probe; negative if there is none
  int64_t probe_steps_ = 0;
  int64_t expected_radius_ = 0;
};

// The balls in the order of the grid's cubes.
struct BallSet {
  // Kernels read several balls at once, so that memory behind the last ball must be readable.
  static constexpr uint32_t read_behind = 7;

  Span<double> x, y, z, r;  // lattice steps, integers
  Span<uint32_t> caller;    // the caller's index of each ball
  uint32_t n = 0;
  exact::Lattice lattice;
  int64_t probe_steps = 0;
  int64_t largest_radius = 0;
  int64_t smallest_radius = no_radius;  // of the radii that were above 0 before they were rounded

  // Room for so many balls.
  void carve(Workspace &workspace, uint32_t capacity) {
    // All in one array, so that a read behind the last ball of one coordinate reads the next coordinate.
    const uint32_t words = has_lanes ? 2 * capacity : 0;
    const auto numbers = workspace.take<double>(words + 4 * static_cast<uint64_t>(capacity) + read_behind);
    if (!numbers.empty()) {
      const auto coordinate = numbers.part(words, numbers.size());
      x = coordinate.part(0, capacity);
      y = coordinate.part(capacity, 2 * capacity);
      z = coordinate.part(2 * capacity, 3 * capacity);
      r = coordinate.part(3 * capacity, 4 * capacity);
    }
    caller = workspace.take<uint32_t>(static_cast<uint64_t>(capacity) + read_behind);
  }

  // For lanes: the lowest 32 bits of x, y, z and r of each ball side by side, which one instruction reads. They are
  // stored before the array of x. Coordinates of balls that meet differ by less than 2^31, so that the differences of
  // their words are exact.
  int32_t *words() const { return reinterpret_cast<int32_t *>(x.data()) - 4 * uint64_t{x.size()}; }

  exact::LatticeBall ball(uint32_t i) const {
    return {{static_cast<int64_t>(x[i]), static_cast<int64_t>(y[i]), static_cast<int64_t>(z[i])},
            static_cast<int64_t>(r[i]),
            caller[i]};
  }
  bool ranks_before(uint32_t i, uint32_t j) const { return exact::ranks_before(rank_key(i), rank_key(j)); }
  // Whether ball i comes before ball j in the caller's order.
  bool given_before(uint32_t i, uint32_t j) const { return caller[i] < caller[j]; }
  // The vector from the centre of ball i to that of ball j, exactly.
  Vec3 difference(uint32_t i, uint32_t j) const { return {x[j] - x[i], y[j] - y[i], z[j] - z[i]}; }
  exact::Vector exact_difference(uint32_t i, uint32_t j) const {
    const Vec3 v = difference(i, j);
    return {static_cast<int64_t>(v.x), static_cast<int64_t>(v.y), static_cast<int64_t>(v.z)};
  }
  // A hint to the processor: ball i will be read soon. Always inlined: g++ finds no effect in such a function.
  [[gnu::always_inline]] void prefetch(uint32_t i) const {
    __builtin_prefetch(&x[i]);
    __builtin_prefetch(&y[i]);
    __builtin_prefetch(&z[i]);
    __builtin_prefetch(&r[i]);
    __builtin_prefetch(&caller[i]);
  }
  void store(uint32_t i, const exact::LatticeBall &ball) {
    x[i] = static_cast<double>(ball.centre.x);
    y[i] = static_cast<double>(ball.centre.y);
    z[i] = static_cast<double>(ball.centre.z);
    r[i] = static_cast<double>(ball.radius);
    if constexpr (has_lanes) {
      int32_t *const word = words() + 4 * uint64_t{i};
      word[0] = static_cast<int32_t>(ball.centre.x);
      word[1] = static_cast<int32_t>(ball.centre.y);
      word[2] = static_cast<int32_t>(ball.centre.z);
      word[3] = static_cast<int32_t>(ball.radius);
    }
    caller[i] = ball.index;
  }

 private:
  exact::RankKey<double> rank_key(uint32_t i) const { return {x[i], y[i], z[i], r[i], caller[i]}; }
};

}  // namespace hsp
