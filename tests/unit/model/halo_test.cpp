// Images around a set: they come behind all its balls, and are found in the blocks of the cubes that they are near to.
#include "model/halo.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "carved_memory.hpp"
#include "model/cube_grid.hpp"
#include "random_balls.hpp"

namespace {

// Balls on a lattice, of radius 8 at most. Those from `own` on are images, `in_brick` of ten of them wherever the
// others are.
class SetWithImages {
 public:
  SetWithImages(oracle::RandomSource &random, uint32_t own, uint32_t n, int64_t side, int64_t in_brick) : own_(own) {
    memory_.carve(given_, n);
    given_.n = n;
    given_.lattice = hsp::exact::Lattice::with_step(1.0);
    given_.largest_radius = 8;
    for (uint32_t k = 0; k < n; ++k) {
      int64_t at[3];
      const bool around = k >= own && random.in(0, 9) >= in_brick;
      const int64_t axis = random.in(0, 2);
      for (int64_t &x : at) x = random.in(around ? -16 : 0, around ? side + 16 : side - 1);
      if (around) at[axis] = random.in(0, 1) == 0 ? random.in(-16, -1) : random.in(side, side + 16);
      given_.store(k, {{at[0], at[1], at[2]}, random.in(1, 8), k});
    }
    grid_memory_.carve(grid_, n);
    grid_.build(given_, own);
  }

  const hsp::CubeGrid &grid() const { return grid_; }
  const hsp::BallSet &given() const { return given_; }
  uint32_t own() const { return own_; }
  // Whether the cubes of two given balls are the same or neighbours.
  bool are_near(uint32_t i, uint32_t j) const {
    const auto is_next = [](double p, double q) {
      return std::abs((static_cast<int64_t>(p) >> 4) - (static_cast<int64_t>(q) >> 4)) <= 1;
    };
    return is_next(given_.x[i], given_.x[j]) && is_next(given_.y[i], given_.y[j]) && is_next(given_.z[i], given_.z[j]);
  }

 private:
  CarvedMemory memory_, grid_memory_;
  hsp::BallSet given_;
  hsp::CubeGrid grid_;
  uint32_t own_;
};

TEST(Halo, ImagesAreInTheBlocksOfTheCubesThatTheyAreNearTo) {
  oracle::RandomSource random(32);
  uint32_t without = 0, with = 0;
  for (int set = 0; set < 60 && !HasFailure(); ++set) {
    const int64_t side = random.in(1, 128);
    const SetWithImages built(random, 150, 150 + static_cast<uint32_t>(random.in(0, 600)), side, set % 2 * 2);
    const hsp::CubeGrid &grid = built.grid();
    ASSERT_EQ(grid.own_balls(), built.own());
    for (uint32_t i = 0; i < built.own(); ++i) {
      std::vector<bool> is_listed(built.given().n, false);
      const hsp::CubeBlock block = grid.block_around(grid.cube_at(built.given().ball(i).centre));
      bool images = false;
      for (uint32_t k = 0; k < block.ranges; ++k) {
        for (uint32_t j = block.range[k].first; j < block.range[k].last; ++j) {
          const uint32_t given = grid.balls().caller[j];
          ASSERT_FALSE(is_listed[given]);
          ASSERT_EQ(j >= grid.own_balls(), given >= built.own());
          is_listed[given] = true;
          images = images || given >= built.own();
        }
      }
      ++(images ? with : without);
      for (uint32_t j = 0; j < built.given().n; ++j) ASSERT_EQ(is_listed[j], built.are_near(i, j)) << i << ' ' << j;
    }
  }
  EXPECT_GT(with, 1000U);
  EXPECT_GT(without, 300U);
}

}  // namespace
