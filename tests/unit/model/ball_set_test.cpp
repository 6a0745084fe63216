#include "ball_set_cases.hpp"

#include "expect_cases.hpp"

TEST(BallSet, Cases) {
  expect_cases(cases::model_ball_set);
}
