#include "surface_gradients_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfaceGradients, Cases) {
  expect_cases(cases::surface_surface_gradients);
}
