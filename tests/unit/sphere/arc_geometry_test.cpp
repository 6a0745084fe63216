#include "arc_geometry_cases.hpp"

#include "expect_cases.hpp"

TEST(ArcGeometry, Cases) {
  expect_cases(cases::sphere_arc_geometry);
}
