// Balls around a place are found wherever they have moved, each once.
#include "moving/ball_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

using hsp::exact::LatticeBall;

// Balls in cells, some of which are there.
class Cells {
 public:
  Cells(uint32_t n, int64_t side, int64_t largest_small = 0) : there_(n) {
    ball_memory_.carve(balls_, n);
    cell_memory_.carve(cells_, n);
    balls_.n = n;
    cells_.clear(n, side, largest_small);
  }

  void insert(uint32_t i, const LatticeBall &ball) {
    balls_.store(i, ball);
    cells_.insert(i, ball);
    there_[i] = true;
  }
  void remove(uint32_t i) {
    cells_.remove(i);
    there_[i] = false;
  }
  bool has(uint32_t i) const { return there_[i]; }
  auto count() const { return std::count(there_.begin(), there_.end(), true); }
  LatticeBall ball(uint32_t i) const { return balls_.ball(i); }
  const hsp::BallCells &get() const { return cells_; }

  void expect_all_meeting(const LatticeBall &query) const {
    std::vector<uint32_t> found, expected;
    cells_.visit_meeting(balls_, query, [&](uint32_t j) { found.push_back(j); });
    std::sort(found.begin(), found.end());
    for (uint32_t j = 0; j < balls_.n; ++j) {
      if (there_[j] && pair_relation(query, ball(j)) != hsp::exact::PairRelation::disjoint) expected.push_back(j);
    }
    ASSERT_EQ(found, expected);
  }
  // The balls of the cube of ball i.
  std::vector<uint32_t> in_cube_of(uint32_t i) const {
    std::vector<uint32_t> found;
    cells_.visit_cube_of(i, [&](uint32_t j) { found.push_back(j); });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  std::vector<bool> there_;
  hsp::BallSet balls_;
  hsp::BallCells cells_;
  CarvedMemory ball_memory_, cell_memory_;
};

TEST(BallCells, FindsAllThatMeet) {
  oracle::RandomSource random(4);
  for (const uint32_t n : {1U, 5U, 400U}) {
    Cells cells(n, 200);
    const auto random_ball = [&](uint32_t i) {
      const oracle::LatticeBall ball = oracle::ball_in_box(random, random.one_in(9) ? INT64_C(1) << 49 : 700, 0, 100);
      return LatticeBall{{ball.x, ball.y, ball.z}, ball.radius, i};
    };
    for (uint32_t i = 0; i < n; ++i) cells.insert(i, random_ball(i));
    for (int round = 0; round < 300; ++round) {
      const uint32_t i = random.below(n);
      cells.remove(i);
      cells.insert(i, random_ball(i));
      ASSERT_NO_FATAL_FAILURE(cells.expect_all_meeting(random_ball(0)));
    }
  }
}

// Cubes whose hashes are the same are in one tree, however balls come and go: all are found, and no way is long.
TEST(BallCells, CollidingCubes) {
  constexpr uint32_t n = 300;
  constexpr int64_t side = 200;
  oracle::RandomSource random(6);
  Cells cells(n, side);
  const auto insert = [&](uint32_t i) {
    const int64_t k = random.in(0, 150);
    const auto place = [&](int64_t step) { return side * k * step + random.in(0, side - 1); };
    const auto &step = oracle::colliding_steps[0];
    const hsp::exact::Vector centre{place(step[0]), place(step[1]), place(step[2])};
    cells.insert(i, {centre, random.in(1, side / 2), i});
  };
  for (uint32_t round = 0; round < 3000; ++round) {
    const uint32_t i = random.below(n);
    if (cells.has(i)) {
      cells.remove(i);
    } else {
      insert(i);
    }
    if (round % 10 != 0) continue;
    EXPECT_LE(cells.get().longest_way(), 40U);
    ASSERT_NO_FATAL_FAILURE(cells.expect_all_meeting(cells.ball(cells.has(i) ? i : 0)));
  }
  // A box of more cubes than there are balls.
  uint32_t count = 0;
  constexpr int64_t far = 10 * side;
  cells.get().visit_near({-far, -far, -far}, {far, far, far}, 0,
                         [&](uint32_t j) { count += cells.has(j) ? 1U : 1000U; });
  EXPECT_EQ(count, cells.count());
}

// Small balls are in small cubes, also those that were large before.
TEST(BallCells, TwoSizes) {
  constexpr uint32_t n = 400;
  constexpr int64_t side = 2000, largest_small = 20;
  oracle::RandomSource random(8);
  Cells cells(n, side, largest_small);
  const auto random_ball = [&](uint32_t i) {
    const int64_t largest = random.one_in(20) ? side / 2 : random.one_in(4) ? largest_small + 1 : largest_small;
    const oracle::LatticeBall ball = oracle::ball_in_box(random, random.one_in(9) ? 4000 : 300, 0, largest);
    return LatticeBall{{ball.x, ball.y, ball.z}, ball.radius, i};
  };
  EXPECT_EQ(cells.get().side_for(largest_small), 2 * largest_small);
  EXPECT_EQ(cells.get().side_for(largest_small + 1), side);
  for (uint32_t i = 0; i < n; ++i) cells.insert(i, random_ball(i));
  for (int round = 0; round < 600; ++round) {
    const uint32_t i = random.below(n);
    cells.remove(i);
    cells.insert(i, random_ball(i));
    ASSERT_NO_FATAL_FAILURE(cells.expect_all_meeting(random_ball(0)));
    // Balls of one cube are of one size, and none of them is farther away than the cube is wide.
    const int64_t width = cells.get().side_for(cells.ball(i).radius);
    for (const uint32_t j : cells.in_cube_of(i)) {
      ASSERT_EQ(cells.get().side_for(cells.ball(j).radius), width);
      ASSERT_LT(std::abs(cells.ball(j).centre.x - cells.ball(i).centre.x), width);
    }
  }
}

}  // namespace
