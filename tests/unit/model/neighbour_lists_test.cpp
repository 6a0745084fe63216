#include "neighbour_lists_cases.hpp"

#include <vector>

#include "built_grid.hpp"
#include "expect_cases.hpp"

TEST(NeighbourLists, Cases) {
  expect_cases(cases::model_neighbour_lists);
}
TEST(NeighbourLists, CasesForTheBaseline) {
  for (const bool in_lanes : {hsp::has_lanes, false}) {
    cases::small_grid().use(hsp::Target::baseline, in_lanes);
    expect_cases(cases::model_neighbour_lists);
  }
  cases::small_grid().use_own_code();
}

namespace {

struct Lists {
  std::vector<uint32_t> first, ids;
  friend bool operator==(const Lists &, const Lists &) = default;
};

Lists lists_of(const hsp::CubeGrid &grid, hsp::PairRows rows, uint32_t most_cached = hsp::most_cached_ids) {
  const uint32_t n = grid.balls().n;
  Lists lists{std::vector<uint32_t>(n + 1), {}};
  const hsp::Span<uint32_t> first(lists.first.data(), n + 1);
  EXPECT_TRUE(hsp::count_neighbours(grid, rows, first));
  lists.ids.resize(first[n]);
  hsp::list_neighbours(grid, rows, first, {lists.ids.data(), first[n]}, most_cached);
  return lists;
}

// Hundreds of balls in the same cube, and thousands around it, far along an axis too: with wide code as without.
TEST(NeighbourLists, OfCrowdedCubes) {
  cases::Random random(6);
  constexpr int64_t far = INT64_C(1) << 40;
  constexpr struct {
    int64_t extent, middle[3];
  } sets[] = {{3, {}}, {8, {}}, {20, {}}, {60, {}}, {20, {far, 0, 0}}, {20, {0, -far, 0}}, {20, {0, 0, far}}};
  for (const auto &[extent, middle] : sets) {
    constexpr uint32_t n = 2000;
    support::BallList list;
    for (uint32_t i = 0; i < n; ++i) {
      for (const int64_t along : middle) list.xyz.push_back(static_cast<double>(along + random.in(-extent, extent)));
      list.radius.push_back(static_cast<double>(i == 77 ? 10 : random.in(0, 2)));
    }
    BuiltGrid built(list);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    hsp::CubeGrid &grid = built.grid();
    const Lists both = lists_of(grid, hsp::PairRows::both), smaller = lists_of(grid, hsp::PairRows::smaller);
    EXPECT_EQ(both.ids.size(), 2 * smaller.ids.size());
    EXPECT_TRUE(lists_of(grid, hsp::PairRows::both, 0) == both);
    EXPECT_TRUE(lists_of(grid, hsp::PairRows::smaller, 0) == smaller);
    for (const bool in_lanes : {hsp::has_lanes, false}) {
      grid.use(hsp::Target::baseline, in_lanes);
      EXPECT_TRUE(lists_of(grid, hsp::PairRows::both) == both);
      EXPECT_TRUE(lists_of(grid, hsp::PairRows::both, 0) == both);
      EXPECT_TRUE(lists_of(grid, hsp::PairRows::smaller) == smaller);
    }
  }
}

// Few balls in most cubes, so that each ball is asked by itself, but hundreds in one of them, or more than a block has
// room for, and more than a hundred neighbours around it.
TEST(NeighbourLists, OfOneCrowdedCubeAmongMany) {
  cases::Random random(7);
  for (const uint32_t crowd : {100U, 200U, 300U, 1100U}) {
    support::BallList list;
    const auto add = [&](int64_t x, int64_t y, int64_t z, int64_t r) {
      for (const int64_t coordinate : {x, y, z}) list.xyz.push_back(static_cast<double>(coordinate));
      list.radius.push_back(static_cast<double>(r));
    };
    for (int64_t k = 0; k < 1728; ++k) add(20 * (k % 12), 20 * (k / 12 % 12), 20 * (k / 144), random.in(0, 10));
    for (uint32_t k = 0; k < crowd; ++k) add(random.in(100, 103), random.in(100, 103), random.in(100, 103), k % 4);
    BuiltGrid built(list);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    hsp::CubeGrid &grid = built.grid();
    ASSERT_LT(grid.balls().n, 2 * grid.cubes());
    const Lists both = lists_of(grid, hsp::PairRows::both), smaller = lists_of(grid, hsp::PairRows::smaller);
    EXPECT_EQ(both.ids.size(), 2 * smaller.ids.size());
    for (const bool in_lanes : {hsp::has_lanes, false}) {
      grid.use(hsp::Target::baseline, in_lanes);
      EXPECT_TRUE(lists_of(grid, hsp::PairRows::both) == both);
    }
  }
}

}  // namespace
