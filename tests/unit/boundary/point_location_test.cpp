#include "point_location_cases.hpp"

#include "expect_cases.hpp"

TEST(PointLocation, Cases) {
  expect_cases(cases::boundary_point_location);
}
