// Which inputs are refused and which ball is named, what others become on the lattice, and the order of balls in a set.
#pragma once

#include <limits>

#include "cases.hpp"
#include "gridless_balls.hpp"
#include "model/ball_set.hpp"

namespace cases {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite_length = std::numeric_limits<double>::infinity();

// The largest lattice is that of step 1e22, on which radii end at 2^30 steps, about 1.07e31.
struct Prepared {
  uint32_t n;
  double radius[3];
  double probe, step;
  hsp::Status status;
  uint32_t first_bad;
  double lattice_step;  // if accepted
  int64_t probe_steps;
};
constexpr Prepared prepared[] = {
    {0, {}, 0.0, 0.0, hsp::Status::ok, hsp::no_id, 1e-8, 0},
    {0, {}, 1.4, 0.0, hsp::Status::ok, hsp::no_id, 1e-8, 140000000},
    {2, {0.0, 0.0}, 0.0, 0.0, hsp::Status::ok, hsp::no_id, 1e-18, 0},  // points: by their coordinates
    {2, {0.0, 1e-24}, 0.0, 0.0, hsp::Status::range, hsp::no_id, 0, 0},
    {2, {0.0, 1e-24}, 0.0, 1e-30, hsp::Status::ok, hsp::no_id, 1e-30, 0},
    {2, {0.0, 0.0}, 1e-24, 0.0, hsp::Status::range, hsp::no_id, 0, 0},
    {2, {1.0, 1.8}, 0.0, 0.0, hsp::Status::ok, hsp::no_id, 1e-8, 0},
    {2, {1.07, 1.0}, 0.0, 0.0, hsp::Status::ok, hsp::no_id, 1e-9, 0},
    {1, {1.0}, 0.08, 0.0, hsp::Status::ok, hsp::no_id, 1e-8, 8000000},  // the sum is too large for 1e-9
    {1, {1.0}, 0.0004, 0.001, hsp::Status::ok, hsp::no_id, 0.001, 0},
    {1, {1.0}, 0.0005, 0.001, hsp::Status::ok, hsp::no_id, 0.001, 1},  // halves away from zero
    {1, {1.0}, 1.0, 0.25, hsp::Status::ok, hsp::no_id, 0.25, 4},
    {2, {1e300, 1.0}, 0.0, 1.0, hsp::Status::ok, hsp::no_id, 1.0, 0},  // round() refuses the first
    {1, {1e300}, 0.0, 1.0, hsp::Status::range, hsp::no_id, 0, 0},      // too fine a step for any
    {1, {1.0}, not_a_number, 0.0, hsp::Status::not_finite, hsp::no_id, 0, 0},
    {1, {1.0}, 0.0, infinite_length, hsp::Status::not_finite, hsp::no_id, 0, 0},
    {1, {not_a_number}, -1.0, 0.0, hsp::Status::negative, hsp::no_id, 0, 0},
    {1, {1.0}, 0.0, -1.0, hsp::Status::negative, hsp::no_id, 0, 0},
    {3, {1.0, not_a_number, -1.0}, 0.0, 0.0, hsp::Status::not_finite, 1, 0, 0},
    {3, {1.0, 2.0, infinite_length}, 0.0, 1.0, hsp::Status::not_finite, 2, 0, 0},
    {3, {-1.0, not_a_number, 1.0}, 0.0, 0.0, hsp::Status::negative, 0, 0, 0},
    {3, {1.0, 2e31, 1.5e31}, 0.0, 0.0, hsp::Status::range, 1, 0, 0},
    {3, {1.0, 2e31, 2e31}, 0.0, 0.0, hsp::Status::range, 1, 0, 0},
    {3, {1.0, 1e31, 9e30}, 1e31, 0.0, hsp::Status::range, hsp::no_id, 0, 0},  // too large with the probe alone
    {1, {1.0}, 2e31, 0.0, hsp::Status::range, hsp::no_id, 0, 0},
    {1, {1.0}, 0x1p30, 1.0, hsp::Status::range, hsp::no_id, 0, 0},
    {1, {1.0}, 0.0, 0x1p-1074, hsp::Status::range, hsp::no_id, 0, 0}};  // lengths in such steps are infinite

inline uint32_t inputs_are_checked() {
  return first_failing(prepared, [](const Prepared &c) {
    constexpr double xyz[9] = {1e-10, -8e-10, 0, 5e-10, infinite_length, not_a_number, 0, 0, 0};
    hsp::BallRounding rounding;
    uint32_t first_bad = 77;
    if (rounding.prepare({c.n, xyz, c.radius, c.probe, c.step}, first_bad) != c.status) return false;
    return first_bad == c.first_bad && (c.status != hsp::Status::ok || (rounding.lattice().step() == c.lattice_step &&
                                                                        rounding.probe_steps() == c.probe_steps));
  });
}

struct RoundedBall {
  double xyz[3], radius, probe, step;
  hsp::Status status;
  hsp::exact::Vector centre;  // if accepted
  int64_t steps;              // the radius
};
constexpr RoundedBall rounded_balls[] = {
    {{0.1, -0.2, 0.3}, 1.7, 1.4, 0.0, hsp::Status::ok, {10000000, -20000000, 30000000}, 310000000},
    {{12.345, -0.001, 1e6}, 1.52, 0.0, 0.001, hsp::Status::ok, {12345, -1, 1000000000}, 1520},
    {{0.5, -0.5, 1.49}, 1.25, 0.25, 1.0, hsp::Status::ok, {1, -1, 1}, 1},  // radius and probe on their own
    {{0x1p50, -0x1p50, -0.0}, 0.0, 0.0, 1.0, hsp::Status::ok, {INT64_C(1) << 50, -(INT64_C(1) << 50), 0}, 0},
    {{0, 0, 0}, 0x1p30 - 1, 0.0, 1.0, hsp::Status::ok, {0, 0, 0}, (1 << 30) - 1},
    {{0, 0, 0}, 0x1p30 - 3, 2.0, 1.0, hsp::Status::ok, {0, 0, 0}, (1 << 30) - 1},
    {{0, 0, 0}, 0x1p30 - 2, 2.0, 1.0, hsp::Status::range, {}, 0},
    {{0, 0, 0}, 0x1p30 - 0.25, 0.0, 1.0, hsp::Status::range, {}, 0},
    {{0, 0, 0}, 1e300, 0.0, 1.0, hsp::Status::range, {}, 0},
    {{0, 0x1p50 + 1, 0}, 1.0, 0.0, 1.0, hsp::Status::range, {}, 0},
    {{0, 0, -0x1p50 - 1}, 1.0, 0.0, 1.0, hsp::Status::range, {}, 0},
    {{1e300, 0, 0}, 1.0, 0.0, 0.0, hsp::Status::range, {}, 0},
    {{0, not_a_number, 0}, 1.0, 0.0, 0.0, hsp::Status::not_finite, {}, 0},
    {{0, 0, infinite_length}, 1.0, 0.0, 0.0, hsp::Status::not_finite, {}, 0}};

// As the second ball of an input, behind a smaller one.
inline uint32_t balls_are_rounded() {
  return first_failing(rounded_balls, [](const RoundedBall &c) {
    const double xyz[6] = {7, 7, 7, c.xyz[0], c.xyz[1], c.xyz[2]};
    const double radius[2] = {0.0, c.radius};
    hsp::BallRounding rounding;
    uint32_t first_bad = 0;
    hsp::exact::LatticeBall ball{};
    if (rounding.prepare({2, xyz, radius, c.probe, c.step}, first_bad) != hsp::Status::ok) return false;
    if (rounding.round(1, ball) != c.status) return false;
    return c.status != hsp::Status::ok || (ball.centre.x == c.centre.x && ball.centre.y == c.centre.y &&
                                           ball.centre.z == c.centre.z && ball.radius == c.steps && ball.index == 1);
  });
}

// The same balls, all at once; the other ball is in front or behind.
inline uint32_t boxes_are_found() {
  return first_failing(rounded_balls, [](const RoundedBall &c) {
    for (uint32_t place = 0; place < 2; ++place) {
      double xyz[6] = {7, 7, 7, 7, 7, 7};
      double radius[2] = {0.0, 0.0};
      for (uint32_t axis = 0; axis < 3; ++axis) xyz[3 * place + axis] = c.xyz[axis];
      radius[place] = c.radius;
      hsp::BallRounding rounding;
      uint32_t first_bad = 0;
      hsp::LatticeBox box;
      if (rounding.prepare({2, xyz, radius, c.probe, c.step}, first_bad) != hsp::Status::ok) return false;
      if (rounding.find_box(box, first_bad) != c.status) return false;
      if (c.status != hsp::Status::ok) {
        if (first_bad != place) return false;
        continue;
      }
      const hsp::exact::LatticeBall ball = rounding.ball(place);
      const hsp::exact::Vector other = rounding.centre(1 - place);
      const auto spans = [](int64_t low, int64_t high, int64_t a, int64_t b) {
        return low == (a < b ? a : b) && high == (a < b ? b : a);
      };
      if (!(ball.centre.x == c.centre.x && ball.centre.y == c.centre.y && ball.centre.z == c.centre.z)) return false;
      if (ball.radius != c.steps || ball.index != place || rounding.largest_radius() != c.steps) return false;
      if (!spans(box.low.x, box.high.x, other.x, c.centre.x) || !spans(box.low.y, box.high.y, other.y, c.centre.y) ||
          !spans(box.low.z, box.high.z, other.z, c.centre.z)) {
        return false;
      }
    }
    return true;
  });
}

// In the order of rank: x, y, z, radius, and the caller's index.
constexpr hsp::exact::LatticeBall by_rank[] = {{{-(INT64_C(1) << 50), 9, 9}, 9, 5},
                                               {{0, -7, 9}, 9, 6},
                                               {{0, 0, -7}, 9, 7},
                                               {{0, 0, 0}, 3, 8},
                                               {{0, 0, 0}, 9, 1},
                                               {{0, 0, 0}, 9, 2},
                                               {{0, 0, 1}, 0, 0},
                                               {{0, 1, 0}, 0, 4},
                                               {{INT64_C(1) << 50, 0, 0}, 0, 3}};

inline uint32_t sets_keep_balls() {
  GridlessBalls<9> balls;
  for (const hsp::exact::LatticeBall &ball : by_rank) balls.add(ball);
  const hsp::BallSet &set = balls.set();
  for (uint32_t i = 0; i < 9; ++i) {
    const hsp::exact::LatticeBall &own = by_rank[i];
    const hsp::exact::LatticeBall kept = set.ball(i);
    if (kept.centre.x != own.centre.x || kept.centre.y != own.centre.y || kept.centre.z != own.centre.z) return i;
    if (kept.radius != own.radius || kept.index != own.index) return i;
    for (uint32_t j = 0; j < 9; ++j) {
      const hsp::exact::LatticeBall &other = by_rank[j];
      if (set.ranks_before(i, j) != (i < j) || set.given_before(i, j) != (own.index < other.index)) return i;
      const hsp::exact::Vector from = set.exact_difference(i, j);
      const hsp::Vec3 rounded_from = set.difference(i, j);
      if (from.x != other.centre.x - own.centre.x || from.y != other.centre.y - own.centre.y ||
          from.z != other.centre.z - own.centre.z || rounded_from.x != static_cast<double>(from.x) ||
          rounded_from.y != static_cast<double>(from.y) || rounded_from.z != static_cast<double>(from.z)) {
        return i;
      }
    }
  }
  return all_hold;
}

inline constexpr Check model_ball_set[] = {{"inputs_are_checked", inputs_are_checked},
                                           {"balls_are_rounded", balls_are_rounded},
                                           {"boxes_are_found", boxes_are_found},
                                           {"sets_keep_balls", sets_keep_balls}};

}  // namespace cases
