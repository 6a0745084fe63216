#include "surface_positions_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfacePositions, Cases) {
  expect_cases(cases::surface_surface_positions);
}
