// Balls around a place are found wherever they have moved, each once.
#include "moving/ball_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

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

// Cubes whose hashes are the same are in one tree, however balls come and go: all are found, and no way is long.
TEST(BallCells, CollidingCubes) {
  constexpr uint32_t n = 300;
  constexpr int64_t side = 200;
  oracle::RandomSource random(6);
  hsp::BallSet balls;
  hsp::BallCells cells;
  CarvedMemory memory, cell_memory;
  memory.carve(balls, n);
  cell_memory.carve(cells, n);
  balls.n = n;
  cells.clear(n, side);
  std::vector<bool> there(n);
  const auto insert = [&](uint32_t i) {
    const int64_t k = random.in(0, 150);
    const auto place = [&](int64_t step) { return side * k * step + random.in(0, side - 1); };
    const auto &step = oracle::colliding_steps[0];
    balls.store(i, {{place(step[0]), place(step[1]), place(step[2])}, random.in(1, side / 2), i});
    cells.insert(i, balls.ball(i).centre);
    there[i] = true;
  };
  for (uint32_t round = 0; round < 3000; ++round) {
    const uint32_t i = random.below(n);
    if (there[i]) {
      cells.remove(i);
      there[i] = false;
    } else {
      insert(i);
    }
    if (round % 10 != 0) continue;
    EXPECT_LE(cells.longest_way(), 40U);
    const hsp::exact::LatticeBall query = balls.ball(there[i] ? i : 0);
    std::vector<uint32_t> found, expected;
    cells.visit_meeting(balls, query, [&](uint32_t j) { found.push_back(j); });
    std::sort(found.begin(), found.end());
    for (uint32_t j = 0; j < n; ++j) {
      if (there[j] && pair_relation(query, balls.ball(j)) != hsp::exact::PairRelation::disjoint) expected.push_back(j);
    }
    ASSERT_EQ(found, expected);
  }
  // A box of more cubes than there are balls.
  uint32_t count = 0;
  constexpr int64_t far = 10 * side;
  cells.visit_box({-far, -far, -far}, {far, far, far}, [&](uint32_t j) { count += there[j] ? 1U : 1000U; });
  EXPECT_EQ(count, std::count(there.begin(), there.end(), true));
}

}  // namespace
