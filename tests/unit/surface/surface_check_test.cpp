#include "surface_check_cases.hpp"

#include "expect_cases.hpp"

TEST(SurfaceCheck, Cases) {
  expect_cases(cases::surface_surface_check);
}
