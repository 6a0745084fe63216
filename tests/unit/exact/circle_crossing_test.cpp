#include "circle_crossing_cases.hpp"

#include "expect_cases.hpp"

TEST(CircleCrossing, Cases) {
  expect_cases(cases::exact_circle_crossing);
}
