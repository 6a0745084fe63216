#include "surface_map_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfaceMap, Cases) {
  expect_cases(cases::surface_surface_map);
}
