#include "surface_patches_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfacePatches, Cases) {
  expect_cases(cases::surface_surface_patches);
}
