// Balls around a place are found wherever they have moved, each once; linear forms tell the cubes of a box apart.
#include "updates/ball_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

TEST(BallCells, NearCubesHaveDifferentForms) {
  constexpr int64_t far = 16;
  for (int64_t x = -far; x <= far; ++x) {
    for (int64_t y = -far; y <= far; ++y) {
      for (int64_t z = -far; z <= far; ++z) {
        EXPECT_EQ(hsp::linear_hash({x, y, z}) == 0, x == 0 && y == 0 && z == 0);
      }
    }
  }
}

TEST(BallCells, FindsAllThatMeet) {
  oracle::RandomSource random(4);
  for (const uint32_t n : {1U, 5U, 400U}) {
    hsp::BallSet balls;
    hsp::BallCells cells;
    CarvedMemory memory, cell_memory;
    memory.carve(balls, n);
    cell_memory.carve(cells, n);
    balls.n = n;
    cells.clear(n, 200);
    const auto random_ball = [&](uint32_t i) {
      const oracle::LatticeBall ball = oracle::ball_in_box(random, random.one_in(9) ? INT64_C(1) << 49 : 700, 0, 100);
      return hsp::exact::LatticeBall{{ball.x, ball.y, ball.z}, ball.radius, i};
    };
    for (uint32_t i = 0; i < n; ++i) {
      balls.store(i, random_ball(i));
      cells.insert(i, balls.ball(i).centre);
    }
    for (int round = 0; round < 300; ++round) {
      const uint32_t i = random.below(n);
      cells.remove(i);
      balls.store(i, random_ball(i));
      cells.insert(i, balls.ball(i).centre);
      const hsp::exact::LatticeBall query = random_ball(0);
      std::vector<uint32_t> found, expected;
      cells.visit_meeting(balls, query, [&](uint32_t j) { found.push_back(j); });
      std::sort(found.begin(), found.end());
      for (uint32_t j = 0; j < n; ++j) {
        if (pair_relation(query, balls.ball(j)) != hsp::exact::PairRelation::disjoint) expected.push_back(j);
      }
      EXPECT_EQ(found, expected);
    }
  }
}

}  // namespace
