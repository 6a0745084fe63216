#include "circles_in_integers_cases.hpp"

#include "expect_cases.hpp"

TEST(CirclesInIntegers, Cases) {
  expect_cases(cases::surface_circles_in_integers);
}
