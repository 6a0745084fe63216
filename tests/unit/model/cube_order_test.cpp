// The numbering of cubes by rows: a permutation of what was there, rows together and ascending, and the table still
// finds them.
#include "model/cube_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "random_balls.hpp"

namespace {

using Place = std::tuple<int64_t, int64_t, int64_t>;

Place place(const hsp::CubeCoordinates &cube) {
  return {cube.x, cube.y, cube.z};
}

void expect_ordered_rows(const std::vector<hsp::CubeCoordinates> &cubes) {
  const uint32_t n = static_cast<uint32_t>(cubes.size());
  std::vector<uint32_t> slots(hsp::CubeTable::slots_for(n)), scratch_slots(slots.size()), links(n), order(n);
  std::vector<hsp::CubeCoordinates> coordinates(n);
  const auto span = [](std::vector<uint32_t> &v) {
    return hsp::Span<uint32_t>(v.data(), static_cast<uint32_t>(v.size()));
  };
  hsp::CubeTable table(span(slots), hsp::Span<hsp::CubeCoordinates>(coordinates.data(), n));
  table.clear(n);
  for (const hsp::CubeCoordinates &cube : cubes) table.find_or_insert(cube);
  const std::vector<hsp::CubeCoordinates> before(coordinates.begin(), coordinates.begin() + table.count());

  hsp::order_cubes_by_rows(table, {span(scratch_slots), span(links), span(order)});

  std::set<std::tuple<int64_t, int64_t>> finished_rows;
  for (uint32_t k = 0; k < table.count(); ++k) {
    const hsp::CubeCoordinates &cube = table.coordinates(k);
    EXPECT_EQ(table.find(cube), k);
    if (k == 0) continue;
    const hsp::CubeCoordinates &last = table.coordinates(k - 1);
    if (last.y == cube.y && last.z == cube.z) {
      EXPECT_LT(last.x, cube.x);
    } else {
      finished_rows.insert({last.y, last.z});
      EXPECT_EQ(finished_rows.count({cube.y, cube.z}), 0U) << "a row in two pieces";
    }
  }
  for (uint32_t old = 0; old < before.size(); ++old) {
    EXPECT_EQ(place(table.coordinates(links[old])), place(before[old]));
  }
}

TEST(CubeOrder, OfRandomCubes) {
  oracle::RandomSource random(21);
  for (int round = 0; round < 200; ++round) {
    const int64_t width = random.in(1, 60);
    std::vector<hsp::CubeCoordinates> cubes;
    for (int k = 0; k < round; ++k) {
      const auto coordinate = [&random](int64_t range) { return random.in(-range, range); };
      cubes.push_back({coordinate(width), coordinate(3), coordinate(2)});
    }
    expect_ordered_rows(cubes);
  }
}

TEST(CubeOrder, OfOneLongRowBackwards) {
  std::vector<hsp::CubeCoordinates> cubes;
  for (int64_t k = 5000; k > -5000; --k) cubes.push_back({k * 1000003, -7, 9});
  expect_ordered_rows(cubes);
}

TEST(CubeOrder, OfNothing) {
  expect_ordered_rows({});
}

}  // namespace
