// The balls around one cube as the floats they are rounded to: which of them meet a ball of the block, by integers.
#include "model/rounded_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "built_grid.hpp"
#include "model/queries.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

#if HSP_LANES
namespace {

using hsp::RoundedBlock;
using oracle::LatticeBall;
using oracle::RandomSource;

bool meet_in_integers(const hsp::BallSet &balls, uint32_t i, uint32_t j) {
  const auto integer = [](double value) { return static_cast<int64_t>(value); };
  const int64_t dx = integer(balls.x[i] - balls.x[j]), dy = integer(balls.y[i] - balls.y[j]),
                dz = integer(balls.z[i] - balls.z[j]), sum = integer(balls.r[i] + balls.r[j]);
  return dx * dx + dy * dy + dz * dz <= sum * sum;
}

support::BallList to_list(const std::vector<LatticeBall> &balls) {
  support::BallList list;
  for (const LatticeBall &ball : balls) {
    for (const int64_t coordinate : {ball.x, ball.y, ball.z}) list.xyz.push_back(static_cast<double>(coordinate));
    list.radius.push_back(static_cast<double>(ball.radius));
  }
  return list;
}

// Each ball of the ranges against all of them.
void expect_met(hsp::Target target, const hsp::CubeGrid &grid, const std::vector<hsp::BallRange> &ranges) {
  const hsp::BallSet &balls = grid.balls();
  const hsp::QueryArrays arrays = query_arrays(balls);
  RoundedBlock block;
  ASSERT_TRUE(fill_block(target, block, *grid.queries(), arrays, ranges.data(), static_cast<uint32_t>(ranges.size())));
  std::vector<uint32_t> places;
  for (const hsp::BallRange &range : ranges) {
    for (uint32_t j = range.first; j < range.last; ++j) places.push_back(j);
  }
  ASSERT_EQ(block.count, places.size());
  for (const uint32_t i : places) {
    std::vector<uint32_t> expected;
    for (const uint32_t j : places) {
      if (j != i && meet_in_integers(balls, i, j)) expected.push_back(balls.caller[j]);
    }
    ASSERT_EQ(count_in_block(target, block, arrays, i), expected.size() + 1) << "ball " << i;
    hsp::QueryHits hits;
    find_others_in_block(target, block, arrays, i, hits);
    ASSERT_EQ(hits.count, expected.size()) << "ball " << i;
    const auto stored = static_cast<std::ptrdiff_t>(std::min(hits.count, hsp::QueryHits::room));
    ASSERT_TRUE(std::equal(expected.begin(), expected.begin() + stored, hits.ids)) << "ball " << i;
  }
}

class RoundedBlockOf : public testing::TestWithParam<hsp::Target> {};
INSTANTIATE_TEST_SUITE_P(Targets, RoundedBlockOf, testing::ValuesIn(runnable_targets()));

// Few digits, so that many pairs touch, at every scale; a step beside touching at the largest; far from the origin.
TEST_P(RoundedBlockOf, MeetsAsIntegersSay) {
  RandomSource random(57);
  int with_floats = 0;
  for (int round = 0; round < 1500; ++round) {
    const int64_t largest = random.in(1, 6), unit = int64_t{1} << random.in(0, 25);
    const int64_t beside = random.one_in(2) ? 1 : 0, far = random.one_in(3) ? int64_t{1} << 49 : 0;
    const auto n = static_cast<uint32_t>(random.in(10, 60));
    std::vector<LatticeBall> set;
    for (uint32_t i = 0; i < n; ++i) {
      const auto coordinate = [&] {
        return far + unit * random.in(-3 * largest, 3 * largest) + random.in(-beside, beside);
      };
      set.push_back({coordinate(), coordinate(), coordinate(), 0});
      set.back().radius = random.one_in(2) ? largest * unit : unit * random.in(0, largest);
    }
    const BuiltGrid built(to_list(set));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    if (built.grid().queries()->rounded == nullptr) continue;
    ++with_floats;
    // Ascending, some of them empty, more than two eights in others.
    std::vector<hsp::BallRange> ranges;
    for (uint32_t from = 0; ranges.size() < RoundedBlock::most_ranges && from < n;) {
      const auto last = static_cast<uint32_t>(random.in(from, std::min(n, from + 20)));
      ranges.push_back({from, last});
      from = last + static_cast<uint32_t>(random.in(0, 2));
    }
    expect_met(GetParam(), built.grid(), ranges);
  }
  EXPECT_GT(with_floats, 500);
}

// As far from the middle as sets are rounded: floats cannot tell a distance of many radii from none.
TEST_P(RoundedBlockOf, MeetsAtTheEndsOfALongRow) {
  std::vector<LatticeBall> set;
  for (int64_t k = 0; k < 4000; ++k) set.push_back({1000 * k, k % 3, 0, 400 + k % 200});
  const BuiltGrid built(to_list(set));
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_NE(built.grid().queries()->rounded, nullptr);
  for (const uint32_t from : {0U, 2000U, 3900U}) expect_met(GetParam(), built.grid(), {{from, from + 100}});
}

TEST_P(RoundedBlockOf, RefusesWhatItHasNoRoomFor) {
  constexpr uint32_t room = RoundedBlock::room;
  const BuiltGrid built(to_list(std::vector<LatticeBall>(room + 20, LatticeBall{0, 0, 0, 1})));
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_NE(built.grid().queries()->rounded, nullptr);
  expect_met(GetParam(), built.grid(), {{0, room}});
  expect_met(GetParam(), built.grid(), {{0, 3}, {20, room + 17}});
  RoundedBlock block;
  for (const hsp::BallRange &range : {hsp::BallRange{20, room + 18}, hsp::BallRange{4, room + 2}}) {
    const hsp::BallRange ranges[2] = {{0, 3}, range};
    EXPECT_FALSE(fill_block(GetParam(), block, *built.grid().queries(), query_arrays(built.grid().balls()), ranges, 2));
  }
}

}  // namespace
#else
TEST(RoundedBlock, IsNotInThisBuild) {}
#endif
