#include "floating_point_cases.hpp"

#include "expect_cases.hpp"

TEST(FloatingPoint, Cases) {
  expect_cases(cases::core_floating_point);
}
