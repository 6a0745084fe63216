#include "cusped_circles_cases.hpp"

#include "expect_cases.hpp"

TEST(CuspedCircles, Cases) {
  expect_cases(cases::surface_cusped_circles);
}
