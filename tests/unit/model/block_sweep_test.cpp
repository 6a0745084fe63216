// The blocks of a sweep against those that the table finds: for all cubes of a grid, with cubes left out, by balls, and
// in sets with gaps along each axis.
#include "model/block_sweep.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "random_balls.hpp"

namespace {

class Grid {
 public:
  Grid(const std::vector<double> &xyz, double radius) {
    const uint32_t n = static_cast<uint32_t>(xyz.size() / 3);
    const std::vector<double> radii(n, radius);
    hsp::Workspace measure;
    grid_.carve(measure, n);
    memory_.resize(measure.bytes());
    hsp::Workspace workspace(memory_.data(), memory_.size());
    grid_.carve(workspace, n);
    uint32_t first_bad = 0;
    hsp::BallInput input;
    input.n = n;
    input.xyz = xyz.data();
    input.radius = radii.data();
    input.step = 1.0;
    EXPECT_EQ(grid_.build(input, first_bad), hsp::Status::ok);
  }
  const hsp::CubeGrid &grid() const { return grid_; }

 private:
  std::vector<unsigned char> memory_;
  hsp::CubeGrid grid_;
};

void expect_same(const hsp::CubeBlock &found, const hsp::CubeBlock &expected) {
  ASSERT_EQ(found.ranges, expected.ranges);
  for (uint32_t k = 0; k < found.ranges; ++k) {
    ASSERT_EQ(found.range[k].first, expected.range[k].first) << k;
    ASSERT_EQ(found.range[k].last, expected.range[k].last) << k;
    if (k > 0) {
      ASSERT_LE(found.range[k - 1].last, found.range[k].first) << "ranges descend";
    }
  }
}

void expect_blocks(const hsp::CubeGrid &grid) {
  for (uint32_t stride = 1; stride < 6; ++stride) {
    hsp::BlockSweep sweep(grid);
    for (uint32_t cube = stride - 1; cube < grid.cubes(); cube += stride) {
      expect_same(sweep.block_around(cube), grid.block_around(grid.table().coordinates(cube)));
    }
    hsp::BlockSweep by_ball(grid);
    for (uint32_t ball = stride - 1; ball < grid.balls().n; ball += stride) {
      expect_same(by_ball.block_around_ball(ball), grid.block_around(grid.cube_at(grid.balls().ball(ball).centre)));
    }
  }
}

TEST(BlockSweep, FindsWhatTheTableFinds) {
  oracle::RandomSource random(31);
  for (int round = 0; round < 300; ++round) {
    int64_t width[3];
    for (int64_t &w : width) w = random.in(0, int64_t{1} << random.in(0, 7));
    std::vector<double> xyz;
    const int64_t balls = random.in(1, 400);
    for (int64_t k = 0; k < balls; ++k) {
      for (const int64_t w : width) xyz.push_back(static_cast<double>(random.in(-w, w)));
    }
    const Grid grid(xyz, static_cast<double>(random.in(0, 4)));
    expect_blocks(grid.grid());
  }
}

TEST(BlockSweep, OfFarCubes) {
  const Grid grid({0, 0, 0, 0x1p50, 0x1p50, 0x1p50, -0x1p50, -0x1p50, -0x1p50, -0x1p50, 0x1p50, 0, 0x1p50, 0, 0}, 1.0);
  ASSERT_EQ(grid.grid().cubes(), 5U);
  expect_blocks(grid.grid());
}

TEST(BlockSweep, OfFullRows) {
  std::vector<double> xyz;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) xyz.insert(xyz.end(), {3.0 * x, 3.0 * y, 3.0 * z});
    }
  }
  const Grid grid(xyz, 1.5);
  expect_blocks(grid.grid());
}

}  // namespace
