#include "double_lanes_cases.hpp"

#include "expect_cases.hpp"

TEST(DoubleLanes, Cases) {
  expect_cases(cases::lanes_double_lanes);
}
