#include "degenerate_balls_cases.hpp"

#include "expect_cases.hpp"

TEST(DegenerateBalls, Cases) {
  expect_cases(cases::surface_degenerate_balls);
}
