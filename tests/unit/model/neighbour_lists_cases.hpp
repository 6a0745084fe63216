// All pairs of balls that meet: by hand where they touch, else by a look at every pair.
#pragma once

#include <initializer_list>

#include "model/neighbour_lists.hpp"
#include "small_grid.hpp"

namespace cases {

// Closed balls: to touch is to meet. ids: of both rows.
struct Rows {
  uint32_t n;
  LatticePoint ball[5];
  uint32_t first[6];
  uint32_t ids[8];
};
constexpr Rows rows_of_balls[] = {
    {0, {}, {0}, {}},
    {1, {{0, 0, 0, 5}}, {0, 0}, {}},
    {2, {{0, 0, 0, 0}, {0, 0, 0, 0}}, {0, 1, 2}, {1, 0}},
    {2, {{0, 0, 0, 0}, {0, 0, 1, 0}}, {0, 0, 0}, {}},
    {2, {{0, 0, 0, 3}, {6, 0, 0, 3}}, {0, 1, 2}, {1, 0}},
    {2, {{0, 0, 0, 3}, {7, 0, 0, 3}}, {0, 0, 0}, {}},
    // The last ball is in the middle of all others, which do not meet each other: no larger neighbours but one.
    {5,
     {{9, 0, 0, 1}, {-9, 0, 0, 1}, {0, 9, 0, 1}, {0, -9, 0, 1}, {0, 0, 0, 8}},
     {0, 1, 2, 3, 4, 8},
     {4, 4, 4, 4, 0, 1, 2, 3}},
    // The first one: no smaller neighbours.
    {5,
     {{0, 0, 0, 8}, {9, 0, 0, 1}, {-9, 0, 0, 1}, {0, 9, 0, 1}, {0, -9, 0, 1}},
     {0, 4, 5, 6, 7, 8},
     {1, 2, 3, 4, 0, 0, 0, 0}},
    // Rows without entries in front, between and behind.
    {5, {{90, 0, 0, 5}, {0, 0, 0, 5}, {0, 90, 0, 5}, {3, 0, 0, 5}, {0, 0, 90, 5}}, {0, 0, 1, 1, 2, 2}, {3, 1}},
    // Squares that differ by 1 in 10^18, which doubles cannot tell.
    {3, {{0, 1, 0, 500000000}, {1000000000, 0, 0, 500000000}, {0, 0, 0, 500000000}}, {0, 1, 2, 4}, {2, 2, 0, 1}},
    // Just as far apart as the sides of the cubes are long, across their walls, and one step less far.
    {3, {{0, 4, 4, 5}, {0, -6, 4, 5}, {0, 4, -6, 5}}, {0, 2, 3, 4}, {1, 2, 0, 0}},
    {3, {{0, 9, 9, 5}, {0, 10, 19, 5}, {0, 18, 10, 5}}, {0, 1, 1, 2}, {2, 0}}};

// Room for all pairs of the largest grid, with something behind.
struct ListedRows {
  uint32_t first[SmallGrid::most_balls + 2];
  uint32_t ids[SmallGrid::most_balls * SmallGrid::most_balls];
};
inline constexpr uint32_t untouched_id = 4444;

// False if counting fails.
inline bool list_rows(hsp::PairRows rows, uint32_t n, ListedRows &listed) {
  for (uint32_t &begin : listed.first) begin = untouched_id;
  for (uint32_t &id : listed.ids) id = untouched_id;
  const hsp::Span<uint32_t> first(listed.first, n + 1);
  if (!hsp::count_neighbours(small_grid().grid(), rows, first)) return false;
  static uint32_t counted[SmallGrid::most_balls + 1];
  for (uint32_t i = 0; i <= n; ++i) counted[i] = first[i];
  hsp::list_neighbours(small_grid().grid(), rows, first, {listed.ids, first[n]});
  for (uint32_t i = 0; i <= n; ++i) {
    if (first[i] != counted[i]) return false;
  }
  return listed.first[n + 1] == untouched_id && listed.ids[first[n]] == untouched_id;
}

inline ListedRows &listed_rows() {
  static ListedRows one;  // too large for a stack
  return one;
}

inline uint32_t rows_by_hand() {
  return first_failing(rows_of_balls, [](const Rows &c) {
    ListedRows &listed = listed_rows();
    if (!small_grid().build(c.ball, c.n) || !list_rows(hsp::PairRows::both, c.n, listed)) return false;
    for (uint32_t i = 0; i <= c.n; ++i) {
      if (listed.first[i] != c.first[i]) return false;
    }
    for (uint32_t k = 0; k < c.first[c.n]; ++k) {
      if (listed.ids[k] != c.ids[k]) return false;
    }
    // Of each row what is larger than its ball.
    if (!list_rows(hsp::PairRows::smaller, c.n, listed)) return false;
    uint32_t place = 0;
    for (uint32_t i = 0; i < c.n; ++i) {
      if (listed.first[i] != place) return false;
      for (uint32_t k = c.first[i]; k < c.first[i + 1]; ++k) {
        if (c.ids[k] > i && listed.ids[place++] != c.ids[k]) return false;
      }
    }
    return listed.first[c.n] == place;
  });
}

inline bool touch(const LatticePoint &a, const LatticePoint &b) {
  const int64_t dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z, reach = a.r + b.r;
  return dx * dx + dy * dy + dz * dz <= reach * reach;
}

// Scattered balls: in few cubes and in many, few neighbours and hundreds, radii alike and not.
inline uint32_t rows_among_many() {
  constexpr uint32_t n = SmallGrid::most_balls;
  struct Scatter {
    int64_t extent, least_radius, most_radius;
  };
  constexpr Scatter scatters[] = {{40, 0, 9}, {40, 5, 5}, {200, 3, 3}, {9, 9, 9}, {12, 0, 6}, {40, 0, 0}, {3, 0, 0}};
  static LatticePoint balls[n];
  Random random(5);
  return first_failing(scatters, [&random](const Scatter &c) {
    for (uint32_t round = 0; round < 8; ++round) {
      for (LatticePoint &ball : balls) {
        ball = {random.in(-c.extent, c.extent), random.in(-c.extent, c.extent), random.in(-c.extent, c.extent),
                random.in(c.least_radius, c.most_radius)};
      }
      // Now and then one that meets most of the others.
      if (round % 4 == 1) balls[random.in(0, n - 1)].r = c.extent;
      if (!small_grid().build(balls, n)) return false;
      for (const hsp::PairRows rows : {hsp::PairRows::both, hsp::PairRows::smaller}) {
        ListedRows &listed = listed_rows();
        if (!list_rows(rows, n, listed)) return false;
        uint32_t place = 0;
        for (uint32_t i = 0; i < n; ++i) {
          if (listed.first[i] != place) return false;
          for (uint32_t j = rows == hsp::PairRows::both ? 0 : i + 1; j < n; ++j) {
            if (i != j && touch(balls[i], balls[j]) && listed.ids[place++] != j) return false;
          }
        }
        if (listed.first[n] != place) return false;
      }
    }
    return true;
  });
}

// The most that first[n] can hold, and one more.
struct Lengths {
  uint32_t n;
  uint32_t length[3];
  bool fit;
  uint32_t first[4];
};
constexpr Lengths lengths_of_rows[] = {
    {0, {}, true, {0}},
    {3, {2, 0, 5}, true, {0, 2, 2, 7}},
    {3, {UINT32_C(0x80000000), UINT32_C(0x7FFFFFFF), 0}, true, {0, UINT32_C(0x80000000), UINT32_MAX, UINT32_MAX}},
    {3, {UINT32_C(0x80000000), UINT32_C(0x7FFFFFFF), 1}, false, {0, 0, 0, 0}},
    {3, {UINT32_MAX, UINT32_MAX, 9}, false, {0, 0, 0, 0}}};

inline uint32_t lengths_are_summed() {
  return first_failing(lengths_of_rows, [](const Lengths &c) {
    uint32_t first[4] = {c.length[0], c.length[1], c.length[2], 0};
    if (hsp::sum_up({first, c.n + 1}) != c.fit) return false;
    for (uint32_t i = 0; i <= c.n; ++i) {
      if (first[i] != c.first[i]) return false;
    }
    return true;
  });
}

inline constexpr Check model_neighbour_lists[] = {
    {"rows_by_hand", rows_by_hand}, {"rows_among_many", rows_among_many}, {"lengths_are_summed", lengths_are_summed}};

}  // namespace cases
