// The blocks of a sweep against those that the table finds: for all cubes of a grid, with cubes left out, by balls, and
// in sets with gaps along each axis.
#include "model/block_sweep.hpp"

#include <gtest/gtest.h>

#include "built_grid.hpp"
#include "random_balls.hpp"

namespace {

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

// Row by row from the table, whether there is a directory or not.
hsp::CubeBlock block_by_table(const hsp::CubeGrid &grid, const hsp::CubeCoordinates &at) {
  hsp::CubeBlock block;
  for (int64_t z = at.z - 1; z <= at.z + 1; ++z) {
    for (int64_t y = at.y - 1; y <= at.y + 1; ++y) {
      const hsp::BallRange row = grid.balls_in_row(at.x - 1, at.x + 1, y, z);
      if (!row.empty()) block.range[block.ranges++] = row;
    }
  }
  return block;
}

support::BallList with_radius(support::BallList list, double radius) {
  list.radius.assign(list.xyz.size() / 3, radius);
  return list;
}

void expect_blocks(const support::BallList &list, uint32_t least_cubes = 1) {
  const BuiltGrid built(list);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const hsp::CubeGrid &grid = built.grid();
  ASSERT_GE(grid.cubes(), least_cubes);
  // Any cube or ball may be the first.
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    expect_same(hsp::BlockSweep(grid).block_around(cube), block_by_table(grid, grid.cube_list().coordinates(cube)));
  }
  for (uint32_t ball = 0; ball < grid.balls().n; ball += 3) {
    expect_same(hsp::BlockSweep(grid).block_around_ball(ball),
                block_by_table(grid, grid.cube_at(grid.balls().ball(ball).centre)));
  }
  for (uint32_t stride = 1; stride < 6; ++stride) {
    hsp::BlockSweep sweep(grid);
    for (uint32_t cube = stride - 1; cube < grid.cubes(); cube += stride) {
      expect_same(sweep.block_around(cube), block_by_table(grid, grid.cube_list().coordinates(cube)));
    }
    hsp::BlockSweep by_ball(grid);
    for (uint32_t ball = stride - 1; ball < grid.balls().n; ball += stride) {
      expect_same(by_ball.block_around_ball(ball), block_by_table(grid, grid.cube_at(grid.balls().ball(ball).centre)));
    }
  }
}

TEST(BlockSweep, FindsWhatTheTableFinds) {
  oracle::RandomSource random(31);
  for (int round = 0; round < 300; ++round) {
    int64_t width[3];
    for (int64_t &w : width) w = random.in(0, int64_t{1} << random.in(0, 7));
    support::BallList list;
    const int64_t balls = random.in(1, 400);
    for (int64_t k = 0; k < balls; ++k) {
      for (const int64_t w : width) list.xyz.push_back(static_cast<double>(random.in(-w, w)));
    }
    expect_blocks(with_radius(std::move(list), static_cast<double>(random.in(0, 4))));
  }
}

TEST(BlockSweep, OfFarCubes) {
  expect_blocks(
      with_radius({{0, 0, 0, 0x1p50, 0x1p50, 0x1p50, -0x1p50, -0x1p50, -0x1p50, -0x1p50, 0x1p50, 0, 0x1p50, 0, 0}, {}},
                  1.0),
      5);
}

TEST(BlockSweep, OfFullRows) {
  support::BallList list;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) list.add(3.0 * x, 3.0 * y, 3.0 * z, 1.5);
    }
  }
  expect_blocks(list);
}

}  // namespace
