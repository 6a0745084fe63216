#include "floating_point_cases.hpp"

#include "expect_cases.hpp"

TEST(FloatingPoint, Cases) {
  expect_cases(cases::lanes_floating_point);
}
