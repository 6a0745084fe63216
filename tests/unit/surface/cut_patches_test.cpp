#include "cut_patches_cases.hpp"

#include "expect_cases.hpp"

TEST(CutPatches, Cases) {
  expect_cases(cases::surface_cut_patches);
}
