// Rows of cubes by the directory against those that the hash table finds.
#pragma once

#include "small_grid.hpp"

namespace cases {

// The directory finds what the table finds, row by row.
inline bool rows_are_those_of_the_table(const hsp::CubeGrid &grid, const hsp::CubeCoordinates &low,
                                        const hsp::CubeCoordinates &high) {
  hsp::BallRange found[400];
  const uint32_t count = grid.rows().find(low, high, {found, 400});
  uint32_t expected = 0;
  for (int64_t z = low.z; z <= high.z; ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) {
      const hsp::BallRange row = grid.balls_in_row(low.x, high.x, y, z);
      if (row.empty()) continue;
      if (expected == count || found[expected].first != row.first || found[expected].last != row.last) return false;
      ++expected;
    }
  }
  return expected == count;
}

// Boxes inside, across and beside the set, of one cube and of many.
inline uint32_t rows_are_found() {
  Random random(21);
  for (uint32_t round = 0; round < 60; ++round) {
    static LatticePoint balls[SmallGrid::most_balls];
    const uint32_t n = 1 + random.below(SmallGrid::most_balls);
    const int64_t width = random.in(0, 20), far = round % 4 == 0 ? INT64_C(1) << 49 : 0;
    for (uint32_t i = 0; i < n; ++i) {
      balls[i] = {far + random.in(-width, width), random.in(-width, width) - far, random.in(-width / 2, width),
                  random.in(2, 5)};
    }
    if (!small_grid().build(balls, n)) return round;
    const hsp::CubeGrid &grid = small_grid().grid();
    if (!grid.rows().is_there()) {
      if (width < 10) return round;
      continue;
    }
    for (uint32_t k = 0; k < 200; ++k) {
      hsp::CubeCoordinates low = grid.cube_at({balls[0].x, balls[0].y, balls[0].z});
      low = {low.x + random.in(-9, 9), low.y + random.in(-9, 9), low.z + random.in(-9, 9)};
      const int64_t most = k % 2 == 0 ? 2 : 18;
      const hsp::CubeCoordinates high{low.x + random.in(0, most), low.y + random.in(0, most),
                                      low.z + random.in(0, most)};
      if (!rows_are_those_of_the_table(grid, low, high)) return round;
    }
  }
  return all_hold;
}

// Cubes of side 2 at opposite corners of a box of 5 x 4 x 3 cubes: 6 x 4 x 3 cells, an end for each row included.
inline uint32_t room_decides() {
  const LatticePoint balls[] = {{-1, 1, 1, 1}, {7, 7, 5, 1}};
  if (!small_grid().build(balls, 2)) return 0;
  const hsp::CubeGrid &grid = small_grid().grid();
  uint32_t first_ball[] = {0, 1, 2}, cells[73];
  hsp::RowDirectory rows;
  for (uint32_t &cell : cells) cell = 77;
  rows.build(grid.cube_list(), {first_ball, 3}, {cells, 71});
  if (rows.is_there() || cells[0] != 77) return 1;
  rows.build(grid.cube_list(), {first_ball, 3}, {cells, 72});
  if (!rows.is_there() || cells[72] != 77) return 2;
  hsp::BallRange found[12];
  if (rows.find({-1, 0, 0}, {3, 3, 2}, {found, 12}) != 2) return 3;
  rows.clear();
  return rows.is_there() ? 4 : all_hold;
}

// Two balls as far apart as can be, and none at all: no directory, and none is left over from before.
inline uint32_t wide_sets_have_none() {
  const LatticePoint balls[] = {{-(INT64_C(1) << 50), 0, 0, 1}, {INT64_C(1) << 50, INT64_C(1) << 50, 0, 1}};
  if (!small_grid().build(balls, 1) || !small_grid().grid().rows().is_there()) return 0;
  if (!small_grid().build(balls, 2) || small_grid().grid().rows().is_there()) return 1;
  if (!small_grid().build(balls, 0) || small_grid().grid().rows().is_there()) return 2;
  return all_hold;
}

inline constexpr Check model_row_directory[] = {
    {"rows_are_found", rows_are_found}, {"room_decides", room_decides}, {"wide_sets_have_none", wide_sets_have_none}};

}  // namespace cases
