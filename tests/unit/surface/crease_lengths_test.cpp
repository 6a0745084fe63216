#include "crease_lengths_cases.hpp"

#include "expect_cases.hpp"

TEST(CreaseLengths, Cases) {
  expect_cases(cases::surface_crease_lengths);
}
