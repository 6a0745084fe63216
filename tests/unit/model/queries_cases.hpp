// Which balls a point or a ball meets: by hand where they touch, else by a look at every ball.
#pragma once

#include <cmath>
#include <initializer_list>
#include <limits>

#include "model/queries.hpp"
#include "small_grid.hpp"

namespace cases {

// Closed balls: to touch is to meet.
struct Asked {
  uint32_t n;
  LatticePoint ball[4];
  LatticePoint query;
  uint32_t hits;
  uint32_t id[4];
};
constexpr Asked asked[] = {
    {0, {}, {0, 0, 0, 0}, 0, {}},
    {0, {}, {0, 0, 0, INT64_C(1) << 51}, 0, {}},
    {1, {{0, 0, 0, 5}}, {3, 4, 0, 0}, 1, {0}},
    {1, {{0, 0, 0, 5}}, {3, 4, 1, 0}, 0, {}},
    {1, {{0, 0, 0, 0}}, {0, 0, 0, 0}, 1, {0}},
    {1, {{0, 0, 0, 0}}, {0, 0, 1, 0}, 0, {}},
    {1, {{0, 0, 0, 0}}, {0, 0, 1, 1}, 1, {0}},
    {2, {{0, 0, 0, 5}, {0, 0, 0, 5}}, {1, 1, 1, 0}, 2, {0, 1}},
    {3, {{9, 0, 0, 5}, {0, 0, 0, 50}, {-9, 0, 0, 5}}, {0, 0, 0, 4}, 3, {0, 1, 2}},
    {3, {{9, 0, 0, 5}, {0, 50, 0, 5}, {-9, 0, 0, 5}}, {0, 0, 0, 3}, 0, {}},
    {3, {{9, 0, 0, 5}, {0, 50, 0, 5}, {-9, 0, 0, 5}}, {0, 0, 0, 45}, 3, {0, 1, 2}},
    {2, {{0, 0, 0, 10}, {100, 0, 0, 10}}, {0, 0, 0, 89}, 1, {0}},
    {2, {{0, 0, 0, 10}, {100, 0, 0, 10}}, {0, 0, 0, 90}, 2, {0, 1}},
    // At the walls of the cubes, whose side is 10 here.
    {3, {{-1, 4, 4, 5}, {4, -1, 4, 5}, {4, 4, -1, 5}}, {4, 4, 4, 0}, 3, {0, 1, 2}},
    {3, {{10, 5, 5, 5}, {5, 10, 5, 5}, {5, 5, 10, 5}}, {5, 5, 5, 0}, 3, {0, 1, 2}},
    // Sums of squares in double are on the other side of the square of the sum.
    {1, {{0, 0, 0, 889281988}}, {2263565687, 456435133, 932047441, 1600853567}, 0, {}},
    {1, {{0, 0, 0, 764071860}}, {1695270627, 134307344, 43312730, 937062160}, 1, {0}},
    // Squares that differ by 1 in 10^18, which doubles cannot tell.
    {2, {{0, 0, 0, 1000000000}, {0, 1, 0, 1000000000}}, {1000000000, 0, 0, 0}, 1, {0}},
    {2, {{0, 0, 1, 1000000000}, {0, 0, 0, 1000000000}}, {2000000000, 0, 0, 1000000000}, 1, {1}},
    {1, {{600000000, 0, 800000000, 1000000000}}, {0, 0, 0, 0}, 1, {0}},
    // From one end of the lattice to the other.
    {2,
     {{INT64_C(1) << 50, 0, 0, 1}, {-(INT64_C(1) << 50), 0, 0, 0}},
     {-(INT64_C(1) << 50), 0, 0, INT64_C(1) << 51},
     2,
     {0, 1}},
    {1, {{INT64_C(1) << 50, 0, 0, 1}}, {-(INT64_C(1) << 50), 0, 0, (INT64_C(1) << 51) - 2}, 0, {}}};

// An answer with room for `capacity` ids.
struct Answer {
  uint32_t ids[SmallGrid::most_balls];
  hsp::QueryResult result;
  explicit Answer(uint32_t capacity) : result{ids, capacity, 77} {
    for (uint32_t &id : ids) id = 4444;
  }
};

inline uint32_t hits_by_hand() {
  return first_failing(asked, [](const Asked &c) {
    if (!small_grid().build(c.ball, c.n)) return false;
    const hsp::CubeGrid &grid = small_grid().grid();
    const hsp::LatticeQuery query{{c.query.x, c.query.y, c.query.z}, c.query.r};
    if (hsp::any_ball_meets(grid, query) != (c.hits > 0)) return false;
    for (const bool as_point : {false, true}) {
      if (as_point && c.query.r != 0) continue;
      // With one id too little room, just enough, and some to spare.
      for (uint32_t capacity = c.hits > 0 ? c.hits - 1 : 0; capacity < c.hits + 2; ++capacity) {
        Answer answer(capacity);
        if (as_point) {
          hsp::find_balls_at_point(grid, query, answer.result);
        } else {
          hsp::find_balls_at_ball(grid, query, answer.result);
        }
        if (answer.result.hits != c.hits) return false;
        const uint32_t stored = c.hits <= capacity ? c.hits : 0;
        for (uint32_t k = 0; k < SmallGrid::most_balls; ++k) {
          if (answer.ids[k] != (k < stored ? c.id[k] : 4444)) return false;
        }
      }
    }
    return true;
  });
}

inline bool meet(const LatticePoint &a, const LatticePoint &b) {
  const int64_t dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z, reach = a.r + b.r;
  return dx * dx + dy * dy + dz * dz <= reach * reach;
}
inline bool are_those_that_meet(const LatticePoint *balls, uint32_t n, const LatticePoint &query, uint32_t excluded,
                                const Answer &answer) {
  uint32_t hits = 0;
  for (uint32_t i = 0; i < n; ++i) {
    if (i != excluded && meet(balls[i], query) && answer.ids[hits++] != i) return false;
  }
  return answer.result.hits == hits;
}

// Not in the order of their cubes.
inline void scatter(Random &random, LatticePoint (&balls)[SmallGrid::most_balls]) {
  for (LatticePoint &ball : balls) {
    ball = {random.in(-40, 40), random.in(-40, 40), random.in(-40, 40), random.in(0, 9)};
  }
}

// Scattered balls, and queries of all sizes: from no hit to all of them.
inline uint32_t hits_among_many() {
  constexpr uint32_t n = SmallGrid::most_balls;
  Random random(2);
  static LatticePoint balls[n];
  scatter(random, balls);
  if (!small_grid().build(balls, n)) return 0;
  const hsp::CubeGrid &grid = small_grid().grid();
  uint32_t of_size[4] = {};  // none, few, tens, hundreds
  for (int64_t radius = 0; radius <= 150; ++radius) {
    for (uint32_t k = 0; k < 4; ++k) {
      const LatticePoint query{random.in(-50, 50), random.in(-50, 50), random.in(-50, 50), k == 0 ? 0 : radius};
      Answer at_ball(n);
      hsp::find_balls_at_ball(grid, {{query.x, query.y, query.z}, query.r}, at_ball.result);
      if (!are_those_that_meet(balls, n, query, hsp::no_id, at_ball)) return 1;
      if (hsp::any_ball_meets(grid, {{query.x, query.y, query.z}, query.r}) != (at_ball.result.hits > 0)) return 2;
      ++of_size[at_ball.result.hits == 0 ? 0 : at_ball.result.hits <= 24 ? 1 : at_ball.result.hits <= 128 ? 2 : 3];
      // The radius of a query for a point has no effect.
      const LatticePoint point{query.x, query.y, query.z, 0};
      Answer at_point(n);
      hsp::find_balls_at_point(grid, {{query.x, query.y, query.z}, 33}, at_point.result);
      if (!are_those_that_meet(balls, n, point, hsp::no_id, at_point)) return 3;
    }
  }
  for (const uint32_t times : of_size) {
    if (times < 20) return 4;
  }
  return all_hold;
}

// Of scattered balls, and of one that meets most of them.
inline uint32_t neighbours_of_balls() {
  constexpr uint32_t n = SmallGrid::most_balls;
  Random random(3);
  static LatticePoint balls[n];
  scatter(random, balls);
  for (const int64_t largest : {9, 60}) {
    balls[7].r = largest;
    if (!small_grid().build(balls, n)) return 0;
    const hsp::CubeGrid &grid = small_grid().grid();
    for (uint32_t i = 0; i < n; ++i) {
      Answer neighbours(n);
      hsp::find_neighbours(grid, grid.grid_index(i), neighbours.result);
      if (!are_those_that_meet(balls, n, balls[i], i, neighbours)) return 1;
      if (i == 7 && (neighbours.result.hits > 128) != (largest == 60)) return 2;
    }
  }
  return all_hold;
}

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// On the lattice of step 1/4.
struct RoundedQuery {
  double xyz[3], radius;
  hsp::Status status;
  LatticePoint expected;
};
constexpr RoundedQuery rounded_queries[] = {
    {{1.0, -2.5, 0.3}, 0.75, hsp::Status::ok, {4, -10, 1, 3}},
    {{0.125, -0.125, 0.124}, 0.125, hsp::Status::ok, {1, -1, 0, 1}},
    {{0x1p48, -0x1p48, 0}, 0x1p49, hsp::Status::ok, {INT64_C(1) << 50, -(INT64_C(1) << 50), 0, INT64_C(1) << 51}},
    {{0x1p48 + 1, 0, 0}, 1.0, hsp::Status::range, {}},
    {{0, -0x1p48 - 1, 0}, 1.0, hsp::Status::range, {}},
    {{0, 0, 0}, 0x1p49 + 1, hsp::Status::range, {}},
    {{0, 0, 1e308}, 1.0, hsp::Status::range, {}},
    {{0, 0, 0}, -1.0, hsp::Status::negative, {}},
    {{0, 0, 0}, no_number, hsp::Status::not_finite, {}},
    {{0, 0, no_number}, -1.0, hsp::Status::not_finite, {}},
    {{-std::numeric_limits<double>::infinity(), 0, 0}, 1.0, hsp::Status::not_finite, {}}};

inline uint32_t queries_are_rounded() {
  return first_failing(rounded_queries, [](const RoundedQuery &c) {
    hsp::BallSet balls;
    balls.lattice = hsp::exact::Lattice::with_step(0.25);
    hsp::LatticeQuery query{{7, 7, 7}, 7};
    if (hsp::round_query(balls, c.xyz, c.radius, query) != c.status) return false;
    return c.status != hsp::Status::ok || (query.centre.x == c.expected.x && query.centre.y == c.expected.y &&
                                           query.centre.z == c.expected.z && query.radius == c.expected.r);
  });
}

// Whole queries against their two steps, on sets with and without a directory of rows: positions between and next to
// places of the lattice, at its limits and beyond, and room for fewer hits than there are.
inline uint32_t whole_queries() {
  constexpr uint32_t n = SmallGrid::most_balls;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double odd[] = {0.0,    -0.0,    0.5,     -0.5,   0x1p50,  -0x1p50, 0x1p50 + 1, 0x1p51,    0x1p51 + 1,
                            -1e-30, -0x1p52, -0x1p60, 1e-300, -1e-300, 1e308,   no_number,  -infinite, infinite};
  Random random(4);
  static LatticePoint balls[n];
  scatter(random, balls);
  uint32_t answered = 0, refused = 0, cut = 0;
  for (const int64_t far : {0, 1000000}) {
    balls[3].x += far;
    if (!small_grid().build(balls, n)) return 0;
    const hsp::CubeGrid &grid = small_grid().grid();
    if (grid.rows().is_there() != (hsp::has_row_directories && far == 0)) return 1;
    for (uint32_t round = 0; round < 3000; ++round) {
      const auto quarters = [&random](int64_t most) { return 0.25 * static_cast<double>(random.in(-most, most)); };
      double number[4];
      for (double &x : number) x = quarters(240);
      number[3] = round % 3 == 0 ? 0.0 : std::fabs(quarters(round % 2 == 0 ? 40 : 250));
      if (round % 4 == 0) number[random.below(4)] = odd[random.below(sizeof odd / sizeof odd[0])];
      const uint32_t capacity = round % 5 == 0 ? random.below(20) : n;
      Answer whole(capacity), expected(capacity);
      hsp::LatticeQuery query;
      const hsp::Status status = hsp::round_query(grid.balls(), number, number[3], query);
      if (status == hsp::Status::ok) hsp::find_balls_at_ball(grid, query, expected.result);
      if (hsp::find_balls(grid, number, number[3], whole.result) != status) return 2;
      if (whole.result.hits != expected.result.hits) return 3;
      for (uint32_t k = 0; k < n; ++k) {
        if (whole.ids[k] != expected.ids[k]) return 4;
      }
      ++(status != hsp::Status::ok ? refused : expected.result.hits > capacity ? cut : answered);
    }
  }
  return answered > 3000 && refused > 300 && cut > 100 ? all_hold : 5;
}

inline constexpr Check model_queries[] = {{"hits_by_hand", hits_by_hand},
                                          {"hits_among_many", hits_among_many},
                                          {"neighbours_of_balls", neighbours_of_balls},
                                          {"queries_are_rounded", queries_are_rounded},
                                          {"whole_queries", whole_queries}};

}  // namespace cases
