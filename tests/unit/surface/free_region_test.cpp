#include "free_region_cases.hpp"

#include "expect_cases.hpp"

TEST(FreeRegion, Cases) {
  expect_cases(cases::surface_free_region);
}
