// The balls that are found hidden are hidden: every point of a front above which another ball was to be is looked at,
// by samples. And they are nearly all that are.
#pragma once

#include <cmath>

#include "small_grid.hpp"
#include "small_view.hpp"
#include "view/occlusion.hpp"

namespace cases {

constexpr uint32_t not_hidden = 0xFFFFFFFF;

// How many of the balls of small_grid() are found hidden; not_hidden if one of them is not, at one of 400 points up to
// its rim.
inline uint32_t count_hidden(const hsp::ViewDirection &direction) {
  static unsigned char memory[96 * 1024];
  const hsp::BallSet &balls = small_grid().grid().balls();
  hsp::ViewFrame frame;
  hsp::OcclusionCuller culler;
  hsp::Workspace workspace(memory, sizeof memory);
  culler.carve(workspace, balls.n);
  uint8_t visible[SmallGrid::most_balls];
  for (uint8_t &each : visible) each = 1;
  if (hsp::look_from(direction, frame) != hsp::Status::ok) return not_hidden;
  hsp::centre_on(balls, frame);
  hsp::Patience endless;
  culler.hide(small_grid().grid(), frame, {visible, balls.n}, endless);
  uint32_t hidden = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (visible[i] != 0) continue;
    ++hidden;
    const hsp::Vec3 centre = frame.centre_of(balls, i);
    for (int k = 0; k < 400; ++k) {
      const double distance = balls.r[i] * std::sqrt((k + 0.5) / 400.0), angle = 2.399963 * k;
      const double x = centre.x + distance * std::cos(angle), y = centre.y + distance * std::sin(angle);
      const double own = front_of(balls, frame, i, x, y);
      bool covered = false;
      for (uint32_t j = 0; j < balls.n && !covered; ++j) covered = j != i && front_of(balls, frame, j, x, y) > own;
      if (!covered) return not_hidden;
    }
  }
  return hidden;
}

struct HiddenBalls {
  uint32_t n;
  LatticePoint ball[3];
  hsp::ViewDirection direction;
  uint32_t hidden;
};
constexpr hsp::ViewDirection from_the_front{{0, 0, 1}, {0, 1, 0}}, from_behind{{0, 0, -1}, {0, 1, 0}};
constexpr HiddenBalls hidden_balls[] = {
    // Nothing is above the highest, and of equal balls none is above the other.
    {0, {}, from_the_front, 0},
    {1, {{0, 0, 0, 0}}, from_the_front, 0},
    {1, {{0, 0, 0, 500}}, from_the_front, 0},
    {2, {{0, 0, 0, 0}, {0, 0, 0, 0}}, from_the_front, 0},
    {2, {{0, 0, 0, 1}, {0, 0, 0, 1}}, from_the_front, 0},
    {2, {{0, 0, 0, 500}, {0, 0, 0, 500}}, from_the_front, 0},
    // Of equal balls one behind the other the second one looks out by a single step.
    {2, {{0, 0, 0, 1000000}, {1, 0, -5000000, 1000000}}, from_the_front, 0},
    {2, {{0, 0, 0, 1000}, {0, 0, -2000, 500}}, from_the_front, 1},
    {2, {{0, 0, 0, 1000}, {0, 0, -2000, 500}}, from_behind, 0},
    {3, {{0, 0, 0, 1000}, {0, 0, -2000, 500}, {0, 0, 2000, 500}}, from_behind, 1},
    // Two in one cube, of which the lower one lies behind a ball of a lower cube.
    {3, {{-10, -10, -1900, 1000}, {100, 100, -1950, 10}, {100, 100, -500, 10}}, from_the_front, 1}};

inline uint32_t hidden_by_hand() {
  return first_failing(hidden_balls, [](const HiddenBalls &c) {
    return small_grid().build(c.ball, c.n) && count_hidden(c.direction) == c.hidden;
  });
}

// Behind a large ball all small ones are found, in front of it none.
inline uint32_t what_lies_deep_is_found() {
  LatticePoint balls[50] = {{0, 0, 0, 100000}};
  uint32_t n = 1;
  for (int k = -3; k <= 3; ++k) {
    for (int l = -3; l <= 3; ++l) balls[n++] = {10000 * k, 10000 * l, -200000, 9000};
  }
  const bool conditions[] = {small_grid().build(balls, n), count_hidden(from_the_front) == 49,
                             count_hidden(from_behind) == 0};
  return first_false(conditions);
}

inline void fill_at_random(Random &random, LatticePoint *balls, uint32_t n, int64_t side, int64_t least, int64_t most) {
  for (uint32_t k = 0; k < n; ++k) {
    balls[k] = {random.in(0, side), random.in(0, side), random.in(0, side), random.in(least, most)};
  }
}

inline uint32_t only_what_is_hidden_is_found() {
  Random random(17);
  LatticePoint balls[80];
  uint32_t hidden = 0;
  const auto count = [&](uint32_t n, const hsp::ViewDirection &direction) {
    const uint32_t found = small_grid().build(balls, n) ? count_hidden(direction) : not_hidden;
    hidden = found == not_hidden || hidden == not_hidden ? not_hidden : hidden + found;
  };
  for (uint32_t round = 0; round < 60; ++round) {
    const int64_t least = round % 3 == 0 ? 100 : 20;
    fill_at_random(random, balls, 60, 600, least, 150);
    count(60, from_the_front);
    fill_at_random(random, balls, 60, 500, least, 150);
    count(60, {{1, 1, 1}, {0, 1, 0}});
    fill_at_random(random, balls, 80, 700, least, 200);
    count(80, {{0.3, -0.8, 0.1 * round}, {0, 1, 0}});
    if (hidden == not_hidden) return round;
  }
  return hidden > 2000 ? all_hold : 60;
}

// Far from the origin of the lattice, and in sets so wide that the cells are larger than the balls.
inline uint32_t large_extents() {
  constexpr int64_t far = int64_t{1} << 49;
  Random random(23);
  LatticePoint balls[61] = {};
  fill_at_random(random, balls, 60, 600, 100, 150);
  for (LatticePoint &ball : balls) ball.x += far;
  if (!small_grid().build(balls, 60)) return 0;
  const uint32_t hidden = count_hidden(from_the_front);
  if (hidden == not_hidden || hidden <= 5) return 1;
  balls[60] = {-far, far, 0, 10};
  return small_grid().build(balls, 61) && count_hidden(from_the_front) != not_hidden ? all_hold : 2;
}

inline constexpr Check view_occlusion[] = {{"hidden_by_hand", hidden_by_hand},
                                           {"what_lies_deep_is_found", what_lies_deep_is_found},
                                           {"only_what_is_hidden_is_found", only_what_is_hidden_is_found},
                                           {"large_extents", large_extents}};

}  // namespace cases
