#include "palettes_cases.hpp"

#include "expect_cases.hpp"

TEST(Palettes, Cases) {
  expect_cases(cases::picture_palettes);
}
