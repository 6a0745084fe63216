#include "surface_builder_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfaceBuilder, Cases) {
  expect_cases(cases::surface_surface_builder);
}
