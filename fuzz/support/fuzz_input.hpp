// Sets of balls made from bytes. Uniformly random balls are in general position almost always; these are not: small
// integer coordinates, few different radii, copies, tangencies, several spheres through one point, and single steps of
// the lattice between a tie and none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "ball_list.hpp"
#include "point_lattices.hpp"
#include "set_arrangements.hpp"

// FUZZ_REQUIRE: a condition that must hold. If it does not the program ends, in every build, so that the engine or the
// driver notices.
#define FUZZ_REQUIRE(condition, text)                                                \
  do {                                                                               \
    if (!(condition)) {                                                              \
      std::fprintf(stderr, "%s:%d: %s: %s\n", __FILE__, __LINE__, #condition, text); \
      std::abort();                                                                  \
    }                                                                                \
  } while (false)

namespace fuzz {

// The input, byte by byte, followed by zeros, so that every prefix is an input too.
class Bytes {
 public:
  Bytes(const uint8_t *data, size_t size) : data_(data), size_(size) {}

  bool empty() const { return at_ == size_; }
  uint8_t byte() { return at_ < size_ ? data_[at_++] : uint8_t{0}; }
  uint32_t below(uint32_t limit) {
    uint32_t value = byte();
    if (limit > 256) value |= static_cast<uint32_t>(byte()) << 8;
    return value % limit;
  }
  bool one_in(uint32_t n) { return below(n) == n - 1; }

 private:
  const uint8_t *data_;
  size_t size_;
  size_t at_ = 0;
};

// Lattice balls, the length of a step, and a probe that the library is to add. Squares of distances fit 64 bits.
struct ScaledBalls {
  oracle::Balls balls;
  int64_t probe_steps = 0;
  int64_t steps_per_unit = 1;  // a power of ten; the lattice step is its inverse

  uint32_t n() const { return static_cast<uint32_t>(balls.size()); }
  // The quotient is rounded correctly, so the library finds the integer again.
  double length(int64_t steps) const { return static_cast<double>(steps) / static_cast<double>(steps_per_unit); }
  double step() const { return 1.0 / static_cast<double>(steps_per_unit); }
  int64_t radius_of(size_t i) const { return balls[i].radius + probe_steps; }
  oracle::Balls with_probe() const { return oracle::grown(balls, probe_steps); }

  support::BallList in_lengths() const {
    support::BallList list;
    for (const oracle::LatticeBall &b : balls) list.add(length(b.x), length(b.y), length(b.z), length(b.radius));
    return list;
  }
};

// Vectors with integer components and length, for spheres through common points and exact tangencies in skew
// directions. The length stands as the radius.
inline constexpr oracle::LatticeBall pythagorean[] = {{1, 0, 0, 1},  {0, 1, 0, 1},  {0, 0, 1, 1},  {3, 4, 0, 5},
                                                      {0, 4, 3, 5},  {1, 2, 2, 3},  {2, -1, 2, 3}, {2, 2, -1, 3},
                                                      {-1, 2, 2, 3}, {2, 3, 6, 7},  {6, -2, 3, 7}, {4, 4, 7, 9},
                                                      {1, -4, 8, 9}, {-3, 0, 4, 5}, {2, 6, 9, 11}};

// One more ball, mostly in a special position to one that is there.
inline oracle::LatticeBall next_ball(Bytes &bytes, const ScaledBalls &set, uint32_t span,
                                     const std::vector<int64_t> &radii) {
  const int64_t unit = set.steps_per_unit;
  oracle::LatticePoint centre{};
  const int64_t radius = radii[bytes.below(static_cast<uint32_t>(radii.size()))];
  const auto kind = bytes.below(8);
  if (set.balls.empty() || kind < 3) {
    for (int64_t &coordinate : centre) coordinate = (bytes.below(span) - int64_t{span} / 2) * unit;
    return oracle::ball_around(centre, radius);
  }
  const oracle::LatticeBall &other = set.balls[bytes.below(set.n())];
  centre = centre_of(other);
  const oracle::LatticeBall &direction = pythagorean[bytes.below(static_cast<uint32_t>(std::size(pythagorean)))];
  const int64_t side = bytes.below(2) == 0 ? 1 : -1;
  int64_t distance = 0;  // in steps times direction.radius
  switch (kind) {
    case 3:  // the same place
      break;
    case 4:  // touching from outside
      distance = radius + other.radius + 2 * set.probe_steps;
      break;
    case 5:  // touching from inside
      distance = radius - other.radius;
      break;
    case 6:  // a sphere through the centre of the other
      distance = radius + set.probe_steps;
      break;
    default:  // a whole vector away
      distance = direction.radius * unit;
  }
  // Only multiples of the vector's length lead to integer points; else go along an axis.
  for (size_t axis = 0; axis < 3; ++axis) {
    if (distance % direction.radius == 0) {
      centre[axis] += side * centre_of(direction)[axis] * (distance / direction.radius);
    } else if (axis == static_cast<size_t>(direction.radius) % 3) {
      centre[axis] += side * distance;
    }
  }
  return oracle::ball_around(centre, radius);
}

// A box grid of 2 or 3 balls along each axis, sometimes without one: pores between 8 balls, caverns, tunnels.
inline void add_grid(Bytes &bytes, ScaledBalls &set) {
  const int64_t unit = set.steps_per_unit;
  std::array<int64_t, 3> counts{};
  for (int64_t &count : counts) count = 2 + bytes.below(2);
  const std::array<int64_t, 3> sides{4 * unit, (bytes.one_in(4) ? 2 : 4) * unit, 4 * unit};
  const int64_t radius = 2 + bytes.below(3);  // of 4: touching, with pores, without
  const uint32_t missing = bytes.below(40);
  set.balls = oracle::box_lattice(counts, sides, radius * unit);
  if (missing < set.n()) set.balls.erase(set.balls.begin() + missing);
}

// At most `most` balls, but for a grid of up to 27, within 2^20 steps.
inline ScaledBalls ball_set(Bytes &bytes, uint32_t most) {
  static constexpr int64_t steps_per_unit[] = {1, 10, 1000, 10000};
  ScaledBalls set;
  set.steps_per_unit = steps_per_unit[bytes.below(4)];
  const uint32_t n = bytes.below(most + 1);
  const uint32_t span = 2 + bytes.below(12);
  std::vector<int64_t> radii(1 + bytes.below(3));
  for (int64_t &radius : radii) radius = bytes.below(7) * set.steps_per_unit;
  set.probe_steps = bytes.one_in(4) ? bytes.below(3) * set.steps_per_unit : 0;
  const bool shaken = bytes.one_in(4);
  if (bytes.one_in(5)) add_grid(bytes, set);
  while (set.n() < n) {
    const oracle::LatticeBall next = next_ball(bytes, set, span, radii);
    oracle::LatticePoint centre = centre_of(next);
    int64_t radius = next.radius;
    // one step aside, or one step larger: ties become near ties
    if (shaken && bytes.one_in(3)) {
      const uint32_t what = bytes.below(4);
      if (what < 3) {
        centre[what] += bytes.below(3) - int64_t{1};
      } else {
        radius += 1;
      }
    }
    // chains of tangencies may wander off; those balls go back to the middle
    for (int64_t &coordinate : centre) {
      if (coordinate > (1 << 19) || coordinate < -(1 << 19)) coordinate = 0;
    }
    set.balls.push_back(oracle::ball_around(centre, radius));
  }
  return set;
}

}  // namespace fuzz
