// The table of cubes: every cube is found again, absent ones are not, whatever the coordinates.
#include "model/cube_table.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>
#include <vector>

#include "colliding_cubes.hpp"
#include "random_balls.hpp"

namespace {

struct Table {
  explicit Table(uint32_t cubes) : slots(hsp::CubeSlots::slots_for(cubes)), coordinates(cubes) {
    table = hsp::CubeTable(hsp::Span<uint32_t>(slots.data(), static_cast<uint32_t>(slots.size())),
                           hsp::Span<hsp::CubeCoordinates>(coordinates.data(), cubes));
    table.clear(cubes);
  }
  std::vector<uint32_t> slots;
  std::vector<hsp::CubeCoordinates> coordinates;
  hsp::CubeTable table;
};

// All that are pushed are inserted together.
struct Together {
  explicit Together(uint32_t cubes) : memory(cubes) { list.take({memory.data(), cubes}); }
  void insert_all(Table &own) {
    std::vector<uint32_t> scratch(own.slots.size() / 32 + 1, 0xAAAAAAAA);
    slots = hsp::CubeSlots({own.slots.data(), static_cast<uint32_t>(own.slots.size())});
    slots.insert_all(list.count(), list.cube_of(), {scratch.data(), static_cast<uint32_t>(scratch.size())});
  }
  uint32_t find(const hsp::CubeCoordinates &cube) const {
    return slots.find(cube, hsp::linear_hash(cube), list.cube_of());
  }

  std::vector<hsp::CubeCoordinates> memory;
  hsp::CubeList list;
  hsp::CubeSlots slots;
};

void expect_like_a_map(const std::vector<hsp::CubeCoordinates> &cubes, uint32_t most_probes) {
  Table own(static_cast<uint32_t>(cubes.size()));
  std::map<std::tuple<int64_t, int64_t, int64_t>, uint32_t> expected;
  for (const hsp::CubeCoordinates &cube : cubes) {
    const auto [place, inserted] = expected.insert({{cube.x, cube.y, cube.z}, static_cast<uint32_t>(expected.size())});
    EXPECT_EQ(own.table.find(cube), inserted ? hsp::no_id : place->second);
    if (!inserted) continue;
    own.table.append(cube);
    EXPECT_EQ(own.table.find(cube), place->second);
  }
  EXPECT_EQ(own.table.count(), expected.size());
  EXPECT_GE(own.table.slots().size(), 2 * own.table.count());
  for (const auto &[cube, number] : expected) {
    const auto [x, y, z] = cube;
    EXPECT_EQ(own.table.find({x, y, z}), number);
    EXPECT_EQ(own.table.find({x, y, z + (int64_t{1} << 40)}), hsp::no_id);
  }
  EXPECT_LE(own.table.slots().longest_search(), most_probes);
}

// Cubes that are inserted together have the numbers and the table of those inserted one by one; where there is room for
// more, too. Those of the largest table find their slots by bits.
TEST(CubeTable, ManyAtOnce) {
  for (const uint32_t n : {0U, 1U, 31U, 32U, 33U, 1000U, 40000U}) {
    Table one_by_one(n), room(9 * n);
    Together together(9 * n);
    for (uint32_t k = 0; k < n; ++k) one_by_one.table.append({k % 10, k / 10, -7});
    for (uint32_t k = 0; k < n; ++k) together.list.push({k % 10, k / 10, -7});
    together.insert_all(room);
    ASSERT_EQ(together.slots.size(), one_by_one.table.slots().size());
    room.slots.resize(one_by_one.slots.size());
    EXPECT_EQ(room.slots, one_by_one.slots);
    EXPECT_EQ(together.list.count(), n);
    for (uint32_t k = 0; k < n; ++k) EXPECT_EQ(together.find({k % 10, k / 10, -7}), k);
    EXPECT_EQ(together.find({0, 0, 7}), hsp::no_id);
    EXPECT_EQ(together.slots.longest_search(), one_by_one.table.slots().longest_search());
    if (n == 0) continue;
    EXPECT_EQ(together.list.low(), one_by_one.table.low());
    EXPECT_EQ(together.list.high(), one_by_one.table.high());
  }
}

TEST(CubeTable, BlocksOfNeighbours) {
  std::vector<hsp::CubeCoordinates> cubes;
  for (int64_t x = -10; x < 10; ++x)
    for (int64_t y = -10; y < 10; ++y)
      for (int64_t z = -10; z < 10; ++z) cubes.push_back({x, y, z});
  expect_like_a_map(cubes, 40);
}

TEST(CubeTable, LinesWithLargeStrides) {
  std::vector<hsp::CubeCoordinates> cubes;
  for (int64_t k = 0; k < 3000; ++k) {
    cubes.push_back({k << 32, 0, 0});
    cubes.push_back({0, k << 20, -k});
    cubes.push_back({k << 16, k << 16, k << 16});
  }
  expect_like_a_map(cubes, 60);
}

TEST(CubeTable, RandomWithRepeats) {
  oracle::RandomSource random(1);
  std::vector<hsp::CubeCoordinates> cubes;
  for (int k = 0; k < 20000; ++k) {
    cubes.push_back({random.in(-10, 9), random.in(-10, 9), random.in(-20, 19)});
  }
  expect_like_a_map(cubes, 40);
}

// All have the same hash; the larger table finds slots by bits.
TEST(CubeTable, CollidingCubesManyAtOnce) {
  for (const uint32_t n : {64U, 65U, 1000U, 40000U}) {
    Table room(n);
    Together own(n);
    for (uint32_t k = 0; k < n; ++k) own.list.push(colliding_cube(k));
    own.insert_all(room);
    EXPECT_LE(own.slots.longest_search(), 64U);
    for (uint32_t k = 0; k < n; ++k) {
      const hsp::CubeCoordinates cube = colliding_cube(k);
      ASSERT_EQ(own.find(cube), k);
      ASSERT_EQ(own.find({cube.x + 1, cube.y, cube.z}), hsp::no_id);
    }
    EXPECT_EQ(own.find(colliding_cube(n)), hsp::no_id);
  }
}

TEST(CubeTable, CollidingCubesOneByOne) {
  std::vector<hsp::CubeCoordinates> cubes;
  for (int64_t k = 0; k < 5000; ++k) cubes.push_back(colliding_cube(k * 7 % 4000));
  expect_like_a_map(cubes, 64);
}

TEST(CubeTable, SmallestTablesAreNeverFull) {
  for (uint32_t n = 0; n < 70; ++n) {
    EXPECT_GE(hsp::CubeSlots::slots_for(n), 2ULL * n);
    std::vector<hsp::CubeCoordinates> cubes;
    for (uint32_t k = 0; k < n; ++k) cubes.push_back({k, 7, -3});
    expect_like_a_map(cubes, 70);
  }
}

}  // namespace
