#include "circles_in_doubles_cases.hpp"

#include "expect_cases.hpp"

TEST(CirclesInDoubles, Cases) {
  expect_cases(cases::surface_circles_in_doubles);
}
