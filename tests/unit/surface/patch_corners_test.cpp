#include "patch_corners_cases.hpp"

#include "expect_cases.hpp"

TEST(PatchCorners, Cases) {
  expect_cases(cases::surface_patch_corners);
}
