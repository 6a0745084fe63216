#include "surface_areas_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfaceAreas, Cases) {
  expect_cases(cases::surface_surface_areas);
}
