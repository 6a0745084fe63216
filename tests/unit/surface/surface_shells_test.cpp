#include "surface_shells_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfaceShells, Cases) {
  expect_cases(cases::surface_surface_shells);
}
