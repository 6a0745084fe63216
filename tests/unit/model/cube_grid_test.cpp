// Which cube a point lies in, at the ends of the lattice too: the quotient is estimated in double and has to be
// corrected.
#include "model/cube_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

int64_t floor_of(int64_t value, int64_t side) {
  const int64_t quotient = value / side;
  return value % side < 0 ? quotient - 1 : quotient;
}

void expect_floor(int64_t value, int64_t side) {
  const hsp::CubeCoordinates cube = hsp::CubeGrid::cube_at({value, -value, value / 2}, side);
  ASSERT_EQ(cube.x, floor_of(value, side)) << value << " / " << side;
  ASSERT_EQ(cube.y, floor_of(-value, side)) << -value << " / " << side;
  ASSERT_EQ(cube.z, floor_of(value / 2, side)) << value / 2 << " / " << side;
}

TEST(CubeAt, IsTheFloorEverywhere) {
  oracle::RandomSource random(31);
  constexpr int64_t farthest = (int64_t{1} << 52) - 1;
  for (int k = 0; k < 3000000; ++k) {
    const int64_t side = random.in(1, int64_t{1} << (1 + k % 31));
    const int64_t absolute = farthest >> random.in(0, 7);
    int64_t value = random.in(0, absolute - 1);
    // Next to the walls, where an estimate goes wrong first.
    if (k % 2 == 0) value = value / side * side + random.in(-1, 1);
    expect_floor(value, side);
  }
}

// Balls of an input, of whole coordinates and radii, stand in the order of their cubes, and those of one cube by rank.
void expect_order_of_grid(const std::vector<double> &xyz, const std::vector<double> &radius) {
  const uint32_t n = static_cast<uint32_t>(radius.size());
  CarvedMemory memory;
  hsp::CubeGrid grid;
  memory.carve(grid, n + 5);
  uint32_t first_bad = 0;
  hsp::BallInput input;
  input.n = n;
  input.xyz = xyz.data();
  input.radius = radius.data();
  input.step = 1.0;
  ASSERT_EQ(grid.build(input, first_bad), hsp::Status::ok);
  const hsp::BallSet &balls = grid.balls();
  ASSERT_EQ(balls.n, n);
  int64_t largest = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const hsp::exact::LatticeBall ball = balls.ball(i);
    ASSERT_EQ(grid.grid_index(ball.index), i);
    ASSERT_EQ(static_cast<double>(ball.radius), radius[ball.index]);
    for (size_t axis = 0; axis < 3; ++axis) {
      const int64_t at[3] = {ball.centre.x, ball.centre.y, ball.centre.z};
      ASSERT_EQ(static_cast<double>(at[axis]), xyz[3 * size_t{ball.index} + axis]);
    }
    largest = std::max(largest, ball.radius);
    if (i == 0) continue;
    const hsp::exact::LatticeBall before = balls.ball(i - 1);
    const auto cube = [&](const hsp::exact::LatticeBall &b) {
      return std::tuple(floor_of(b.centre.z, grid.side()), floor_of(b.centre.y, grid.side()),
                        floor_of(b.centre.x, grid.side()));
    };
    ASSERT_TRUE(cube(before) != cube(ball) ? cube(before) < cube(ball) : hsp::exact::ranks_before(before, ball))
        << "ball " << i << " of " << n;
  }
  ASSERT_EQ(balls.largest_radius, largest);
  for (uint32_t c = 0; c < grid.cubes(); ++c) {
    ASSERT_EQ(grid.slots().find(grid.cube_list().coordinates(c), hsp::linear_hash(grid.cube_list().coordinates(c)),
                                grid.cube_list().cube_of()),
              c);
    const hsp::BallRange range = grid.balls_in(c);
    ASSERT_LT(range.first, range.last);
    for (uint32_t i = range.first; i < range.last; ++i) {
      ASSERT_EQ(grid.cube_at(balls.ball(i).centre), grid.cube_list().coordinates(c));
    }
  }
}

// With ties of every kind, with many balls in one place, and with balls so far from each other that their cubes have no
// numbers of 32 bits.
TEST(GridOfAnInput, IsInTheOrderOfCubesAndRank) {
  oracle::RandomSource random(33);
  for (int round = 0; round < 600; ++round) {
    const uint32_t n = static_cast<uint32_t>(random.in(0, 90));
    const int64_t width = int64_t{1} << random.in(0, round % 3 == 0 ? 40 : 8);
    std::vector<double> xyz, radius;
    for (uint32_t k = 0; k < n; ++k) {
      for (size_t axis = 0; axis < 3; ++axis) {
        const bool like_another = k > 0 && random.in(0, 2) == 0;
        const size_t other = static_cast<size_t>(random.in(0, k == 0 ? 0 : int64_t{k} - 1));
        xyz.push_back(like_another ? xyz[3 * other + axis] : static_cast<double>(random.in(-width, width)));
      }
      radius.push_back(static_cast<double>(random.in(1, 3)));
    }
    SCOPED_TRACE(round);
    ASSERT_NO_FATAL_FAILURE(expect_order_of_grid(xyz, radius));
  }
}

// Cubes with very many balls, which are given in the opposite order or in none: from one cube to thousands.
TEST(GridOfAnInput, OfCubesWithManyBalls) {
  oracle::RandomSource random(34);
  for (const uint32_t n : {30U, 511U, 512U, 513U, 2000U}) {
    for (const int64_t width : {int64_t{1}, int64_t{300}, int64_t{5000}, int64_t{1} << 22}) {
      for (const bool descending : {true, false}) {
        std::vector<double> xyz, radius;
        for (uint32_t k = 0; k < n; ++k) {
          const int64_t x = descending ? width - width * k / n : random.in(0, width);
          const int64_t centre[3] = {x, random.in(0, width / 100), random.in(0, width / 100)};
          xyz.insert(xyz.end(), std::begin(centre), std::end(centre));
          radius.push_back(static_cast<double>(random.in(1, 1000)));
        }
        SCOPED_TRACE(std::to_string(n) + " balls, width " + std::to_string(width));
        ASSERT_NO_FATAL_FAILURE(expect_order_of_grid(xyz, radius));
      }
    }
  }
}

}  // namespace
