#include "caps_cases.hpp"

#include <vector>

#include "built_grid.hpp"
#include "expect_cases.hpp"
#include "lattice_lengths.hpp"
#include "model/block_sweep.hpp"
#include "random_balls.hpp"

TEST(Caps, Cases) {
  expect_cases(cases::sphere_caps);
}

// Many of which come behind the ball that contains them.
TEST(Caps, OfContainedBallsAreNone) {
  oracle::RandomSource random(62);
  oracle::Balls balls = oracle::balls_in_box(random, 600, 500, 600, 900);
  balls.push_back({-600, -600, -600, 9000});
  const BuiltGrid built(oracle::in_lengths(balls, 1));
  CarvedMemory memory;
  hsp::Caps caps;
  memory.carve(caps, 600U);
  const uint32_t outer = built.grid().grid_index(600);
  EXPECT_LT(outer, 128U);
  for (uint32_t i = 0; i <= 600; ++i) {
    caps.gather(built.grid().balls(), built.grid().block_around({0, 0, 0}), i, nullptr);
    EXPECT_EQ(caps.contained, i != outer);
    EXPECT_EQ(caps.count, 0U);
  }
}

// Of a part of the balls around one, where small ones among large ones have an index of their own.
TEST(Caps, OfLaterBallsAlone) {
  oracle::RandomSource random(61);
  oracle::Balls balls = oracle::balls_in_box(random, 1500, 30000, 600, 1200);
  const oracle::Balls large = oracle::balls_in_box(random, 40, 30000, 12000, 15000);
  balls.insert(balls.end(), large.begin(), large.end());
  const BuiltGrid built(oracle::in_lengths(balls, 1));
  const hsp::CubeGrid &grid = built.grid();
  ASSERT_NE(grid.levels(), nullptr);
  const uint32_t n = grid.balls().n;
  CarvedMemory memory;
  hsp::Caps caps;
  memory.carve(caps, n);
  hsp::BlockSweep sweep(grid);
  uint32_t some = 0;
  for (uint32_t i = 0; i < n; ++i) {
    hsp::CubeBlock part = sweep.block_around_ball(i);
    part.ranges = 0;
    part.range[part.ranges++] = {i + 1, n};
    caps.gather(grid.balls(), part, i, nullptr);
    std::vector<uint32_t> expected;
    bool contained = false;
    const hsp::exact::LatticeBall own = grid.balls().ball(i);
    for (uint32_t j = i + 1; j < n; ++j) {
      const hsp::exact::LatticeBall other = grid.balls().ball(j);
      const int64_t x = other.centre.x - own.centre.x, y = other.centre.y - own.centre.y;
      const int64_t z = other.centre.z - own.centre.z, squared = x * x + y * y + z * z;
      const int64_t sum = own.radius + other.radius, difference = own.radius - other.radius;
      contained = contained || (difference <= 0 && squared <= difference * difference);
      if (squared <= sum * sum && squared > difference * difference) expected.push_back(j);
    }
    ASSERT_EQ(caps.contained, contained);
    if (contained) continue;
    ASSERT_EQ(std::vector<uint32_t>(caps.ball.data(), caps.ball.data() + caps.count), expected) << "ball " << i;
    some += expected.empty() ? 0U : 1U;
  }
  EXPECT_GT(some, n / 8);
}
