#include "tangency_cases.hpp"

#include <algorithm>
#include <vector>

#include "built_grid.hpp"
#include "expect_cases.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

TEST(Tangency, Cases) {
  expect_cases(cases::measure_tangency);
}

// Small balls inside a large one, whose cubes are so wide that all are around each.
TEST(Tangency, WhereOneBallIsFarLargerFewAreLookedAt) {
  oracle::RandomSource random(113);
  oracle::Balls balls = oracle::balls_in_box(random, 2000, 30000, 500, 1000);
  balls.push_back({0, 0, 0, 60000});
  const BuiltGrid built(oracle::in_lengths(balls, 1));
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const hsp::BallSet &set = built.grid().balls();
  size_t looked_at = 0;
  for (uint32_t i = 0; i < set.n; ++i) {
    std::vector<uint32_t> around;
    hsp::BallsThatMayMeet(built.grid(), i).all_of([&](uint32_t j) {
      around.push_back(j);
      return true;
    });
    EXPECT_TRUE(std::is_sorted(around.begin(), around.end()));
    looked_at += around.size();
    EXPECT_TRUE(hsp::lies_inside_another(built.grid(), i) || set.r[i] == 60000.0);
  }
  EXPECT_LT(looked_at, 10 * balls.size());
}
