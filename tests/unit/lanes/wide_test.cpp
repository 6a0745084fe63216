#include "wide_cases.hpp"

#include "expect_cases.hpp"

TEST(Wide, Cases) {
  expect_cases(cases::lanes_wide);
}
