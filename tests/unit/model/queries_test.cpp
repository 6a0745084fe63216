#include "queries_cases.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "built_grid.hpp"
#include "expect_cases.hpp"

namespace {

// A query ball meets more rows of cubes than are looked up at once.
TEST(Queries, FindBallsInEachOfManyRows) {
  constexpr uint32_t rows = 40;
  support::BallList balls;
  for (uint32_t y = 0; y < rows; ++y) {
    for (uint32_t x = 0; x < 4; ++x) balls.add(2.0 * x, 2.0 * y, 0.0, 1.0);
  }
  BuiltGrid built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  for (double reach = 1.0; reach < 2.0 * rows; reach += 1.0) {
    std::vector<uint32_t> expected;
    for (uint32_t ball = 0; ball < balls.size(); ++ball) {
      const double dx = balls.xyz[3 * ball], dy = balls.xyz[3 * ball + 1];
      if (dx * dx + dy * dy <= (reach + 1.0) * (reach + 1.0)) expected.push_back(ball);
    }
    std::vector<uint32_t> found(balls.size());
    hsp::QueryResult result{found.data(), balls.size(), 0};
    hsp::find_balls_at_ball(built.grid(), {{0, 0, 0}, static_cast<int64_t>(reach)}, result);
    found.resize(result.hits);
    ASSERT_EQ(found, expected) << "radius " << reach;
  }
}

}  // namespace

TEST(Queries, Cases) {
  expect_cases(cases::model_queries);
}
TEST(Queries, CasesForTheBaseline) {
  for (const bool in_lanes : {hsp::has_lanes, false}) {
    cases::small_grid().use(hsp::Target::baseline, in_lanes);
    expect_cases(cases::model_queries);
  }
  cases::small_grid().use_own_code();
}
