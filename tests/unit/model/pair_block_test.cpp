// The balls around one cube as floats: which of them meet a ball of the cube, against integers.
#include "model/pair_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "random_balls.hpp"
#include "runnable_targets.hpp"

#if HSP_LANES
namespace {

using oracle::LatticeBall;
using oracle::RandomSource;

struct Arrays {
  std::vector<double> x, y, z, r;
  std::vector<uint32_t> caller;

  // With something behind the last ball that meets everything.
  explicit Arrays(const std::vector<LatticeBall> &balls) {
    for (const LatticeBall &ball : balls) push(ball);
    for (int k = 0; k < 7; ++k) push({balls[0].x, balls[0].y, balls[0].z, int64_t{1} << 30});
  }
  void push(const LatticeBall &ball) {
    x.push_back(static_cast<double>(ball.x));
    y.push_back(static_cast<double>(ball.y));
    z.push_back(static_cast<double>(ball.z));
    r.push_back(static_cast<double>(ball.radius));
    caller.push_back(static_cast<uint32_t>(5 * caller.size() + 3));
  }
  hsp::QueryArrays arrays() const { return {x.data(), y.data(), z.data(), r.data(), caller.data()}; }
};

bool meet_in_integers(const LatticeBall &a, const LatticeBall &b) {
  const int64_t dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z, sum = a.radius + b.radius;
  return dx * dx + dy * dy + dz * dz <= sum * sum;
}

hsp::PairBlock empty_block(const LatticeBall &centre, double side) {
  hsp::PairBlock block;
  block.count = 0;
  block.doubt = static_cast<float>(hsp::doubt_nearby(side));
  block.centre[0] = static_cast<double>(centre.x);
  block.centre[1] = static_cast<double>(centre.y);
  block.centre[2] = static_cast<double>(centre.z);
  return block;
}

// Ball i against all of the block from each number on.
void expect_met(hsp::Target target, const hsp::PairBlock &block, const Arrays &arrays,
                const std::vector<LatticeBall> &balls, const std::vector<uint32_t> &numbers, uint32_t i) {
  for (uint32_t from = 0; from < block.count; from += 1 + from / 3) {
    std::vector<uint32_t> expected;
    for (uint32_t k = from; k < numbers.size(); ++k)
      if (meet_in_integers(balls[i], balls[numbers[k]])) expected.push_back(arrays.caller[numbers[k]]);
    std::vector<uint32_t> met(hsp::PairBlock::room + hsp::PairBlock::lanes);
    met.resize(met_in_block(target, block, arrays.arrays(), i, from, met.data()));
    ASSERT_EQ(met, expected) << "ball " << i << ", from " << from << " of " << block.count;
  }
}

class PairBlockOf : public testing::TestWithParam<hsp::Target> {};
INSTANTIATE_TEST_SUITE_P(Targets, PairBlockOf, testing::ValuesIn(runnable_targets()));

// Few digits, so that many pairs touch, at every scale; a step beside touching at the largest; far from the origin.
TEST_P(PairBlockOf, MeetsAsIntegersSay) {
  RandomSource random(51);
  for (int round = 0; round < 3000; ++round) {
    const int64_t largest = random.in(1, 6), unit = int64_t{1} << random.in(0, 25), r_max = largest * unit;
    const int64_t beside = random.one_in(2) ? 1 : 0, far = random.one_in(3) ? int64_t{1} << 49 : 0;
    std::vector<LatticeBall> balls;
    const auto n = static_cast<uint32_t>(random.in(1, 60));
    const LatticeBall centre = {far, -far, far / 3, 0};
    for (uint32_t i = 0; i < n; ++i) {
      // The first ones in the cube around the centre, the rest in those around it.
      const int64_t extent = i < 4 ? largest : 3 * largest;
      const auto coordinate = [&](int64_t origin) {
        return origin + unit * random.in(1 - extent, extent - 1) + random.in(-beside, beside);
      };
      balls.push_back({coordinate(centre.x), coordinate(centre.y), coordinate(centre.z), 0});
      balls.back().radius = random.one_in(2) ? r_max : unit * random.in(0, largest);
    }
    const Arrays arrays(balls);
    hsp::PairBlock block = empty_block(centre, 2 * static_cast<double>(r_max));
    std::vector<uint32_t> numbers;
    while (numbers.size() < 80) {
      const auto first = static_cast<uint32_t>(random.in(0, n - 1));
      const auto last = static_cast<uint32_t>(random.in(first, n));
      ASSERT_EQ(add_to_block(GetParam(), block, arrays.arrays(), {first, last}), last);
      for (uint32_t j = first; j < last; ++j) numbers.push_back(j);
    }
    ASSERT_EQ(block.count, numbers.size());
    for (uint32_t i = 0; i < 4 && i < n; ++i) expect_met(GetParam(), block, arrays, balls, numbers, i);
  }
}

// All radii 0: the side of the cubes is 1, and only equal points meet.
TEST_P(PairBlockOf, PointsMeetWhereTheyAreEqual) {
  const std::vector<LatticeBall> balls = {{4, 5, 6, 0}, {4, 5, 6, 0}, {4, 5, 7, 0}, {3, 5, 6, 0}, {4, 5, 6, 0}};
  const Arrays arrays(balls);
  hsp::PairBlock block = empty_block({4, 5, 6, 0}, 1);
  for (double &coordinate : block.centre) coordinate += 0.5;
  add_to_block(GetParam(), block, arrays.arrays(), {0, 5});
  expect_met(GetParam(), block, arrays, balls, {0, 1, 2, 3, 4}, 0);
  expect_met(GetParam(), block, arrays, balls, {0, 1, 2, 3, 4}, 2);
}

// Around the room: what fits is appended, and where the rest begins is reported.
TEST_P(PairBlockOf, TakesWhatItHasRoomFor) {
  constexpr uint32_t room = hsp::PairBlock::room;
  const std::vector<LatticeBall> balls(room + 20, LatticeBall{0, 0, 0, 1});
  const Arrays arrays(balls);
  for (uint32_t already = room - 20; already <= room; ++already)
    for (uint32_t more = 0; more <= 20; ++more) {
      hsp::PairBlock block = empty_block({0, 0, 0, 0}, 2);
      ASSERT_EQ(add_to_block(GetParam(), block, arrays.arrays(), {0, already}), already);
      const uint32_t taken = std::min(more, room - already);
      ASSERT_EQ(add_to_block(GetParam(), block, arrays.arrays(), {7, 7 + more}), 7 + taken);
      ASSERT_EQ(block.count, already + taken);
      uint32_t met[room + hsp::PairBlock::lanes];
      EXPECT_EQ(met_in_block(GetParam(), block, arrays.arrays(), 3, 1, met), block.count - 1);
    }
}

}  // namespace
#else
TEST(PairBlock, IsNotInThisBuild) {}
#endif
