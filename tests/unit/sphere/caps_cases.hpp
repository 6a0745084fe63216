// The cap of one ball on another against its closed form: u along the centres, b = (d^2 + R^2 - r^2)/(2 d R).
#pragma once

#include "small_union.hpp"

namespace cases {

// A ball of radius 5 at the origin, and another one.
struct OneCap {
  SmallBall other;
  uint32_t caps, met;
  bool contained;
  double ux, uy, uz, b;
};
constexpr OneCap one_cap[] = {
    {{8, 0, 0, 5}, 1, 1, false, 1, 0, 0, 0.8},    {{0, 6, 0, 5}, 1, 1, false, 0, 1, 0, 0.6},
    {{0, 0, -3, 4}, 1, 1, false, 0, 0, -1, 0.6},  {{0, 3, 4, 5}, 1, 1, false, 0, 0.6, 0.8, 0.5},
    {{-3, 0, 0, 7}, 1, 1, false, -1, 0, 0, -0.5}, {{10, 0, 0, 5}, 1, 1, false, 1, 0, 0, 1.0},  // touches from outside
    {{11, 0, 0, 5}, 0, 0, false, 0, 0, 0, 0},     {{1, 0, 0, 2}, 0, 1, false, 0, 0, 0, 0},     // inside
    {{0, 0, 1, 10}, 0, 0, true, 0, 0, 0, 0}};                                                  // around

inline uint32_t caps_of_one_ball() {
  return first_failing(one_cap, [](const OneCap &c) {
    const SmallBall balls[] = {{0, 0, 0, 5}, c.other};
    if (!small_union().build(balls, 2)) return false;
    const hsp::Caps &caps = small_union().gathered(0).caps;
    if (caps.count != c.caps || caps.contained != c.contained || (!c.contained && caps.met != c.met)) return false;
    if (caps.count == 0) return true;
    return near(caps.ux[0], c.ux, 1e-15) && near(caps.uy[0], c.uy, 1e-15) && near(caps.uz[0], c.uz, 1e-15) &&
           near(caps.b[0], c.b, 1e-15) && caps.ball[0] == small_union().grid().grid_index(1) &&
           caps.cap_of(caps.ball[0]) == 0;
  });
}

// Six balls around one, of which some are dropped, and half of the sphere is added.
inline uint32_t caps_are_found_dropped_and_added() {
  const SmallBall balls[] = {{0, 0, 0, 10},  {12, 0, 0, 5}, {-12, 0, 0, 5}, {0, 12, 0, 5},
                             {0, -12, 0, 5}, {0, 0, 12, 5}, {0, 0, -12, 5}};
  if (!small_union().build(balls, 7)) return 0;
  hsp::Caps &caps = small_union().gathered(0).caps;
  if (caps.count != 6) return 1;
  for (uint32_t k = 0; k < 6; ++k) {
    if (caps.cap_of(caps.ball[k]) != k || (k > 0 && caps.ball[k] <= caps.ball[k - 1])) return 2;
    if ((k >= caps.first_later) != (caps.ball[k] > caps.origin)) return 3;
  }
  const hsp::BallSet &set = small_union().balls();
  // Those of some balls alone, in another order, are the same.
  const uint32_t chosen[] = {4, 1, 5};
  uint32_t ball[3];
  double all[3][4], given[3][4];
  const auto copy = [&caps](uint32_t k, double(&cap)[4]) {
    const double numbers[] = {caps.ux[k], caps.uy[k], caps.uz[k], caps.b[k]};
    for (uint32_t c = 0; c < 4; ++c) cap[c] = numbers[c];
  };
  for (uint32_t k = 0; k < 3; ++k) {
    ball[k] = caps.ball[chosen[k]];
    copy(chosen[k], all[k]);
  }
  for (uint32_t k = 0; k < 3; ++k) caps.ball[k] = ball[k];
  caps.gather_given(set, caps.origin, 3);
  if (caps.count != 3) return 7;
  for (uint32_t k = 0; k < 3; ++k) {
    copy(k, given[k]);
    for (uint32_t c = 0; c < 4; ++c) {
      if (given[k][c] != all[k][c] || caps.ball[k] != ball[k]) return 8;
    }
  }
  small_union().gathered(0);

  caps.keep_if([&set](uint32_t other) { return set.x[other] == 0.0; });
  if (caps.count != 4) return 4;
  for (uint32_t k = 0; k < 4; ++k) {
    if (set.x[caps.ball[k]] != 0.0 || caps.ux[k] != 0.0 || caps.plane(k).v.x != 0) return 5;
    if ((k >= caps.first_later) != (caps.ball[k] > caps.origin)) return 9;
  }
  caps.add_half_sphere({0, 0, 3000});
  const bool half = caps.count == 5 && caps.ball[4] == hsp::no_id && caps.uz[4] == 1.0 && caps.b[4] == 0.0 &&
                    caps.plane(4).h == 0 && caps.plane(4).perturbed == 0 && caps.length_squared >= 9000000.0;
  return half ? all_hold : 6;
}

// Balls that touch others from inside lie in them, also where doubles round the squares apart; a step farther out they
// do not.
inline uint32_t balls_that_touch_from_inside() {
  constexpr int quadruples[][4] = {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}};
  for (uint32_t k = 0; k < 200; ++k) {
    const auto [x, y, z, d] = quadruples[k % 4];
    const int scale = 90000001 + 98765 * static_cast<int>(k / 4);
    for (const int step : {0, 1}) {
      const SmallBall balls[] = {{0, 0, 0, 1000000000},
                                 {x * scale + step, y * scale, z * scale, 1000000000 - d * scale}};
      if (!small_union().build(balls, 2)) return k;
      const hsp::CubeGrid &grid = small_union().grid();
      if (hsp::lies_inside(grid.balls(), grid.grid_index(1), grid.grid_index(0)) != (step == 0)) return k;
    }
  }
  return all_hold;
}

inline constexpr Check sphere_caps[] = {{"caps_of_one_ball", caps_of_one_ball},
                                        {"balls_that_touch_from_inside", balls_that_touch_from_inside},
                                        {"caps_are_found_dropped_and_added", caps_are_found_dropped_and_added}};

}  // namespace cases
