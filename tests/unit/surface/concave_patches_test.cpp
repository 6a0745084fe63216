#include "concave_patches_cases.hpp"

#include "expect_cases.hpp"

TEST(ConcavePatches, Cases) {
  expect_cases(cases::surface_concave_patches);
}
