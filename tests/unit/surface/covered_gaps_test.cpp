#include "covered_gaps_cases.hpp"

#include "expect_cases.hpp"

TEST(CoveredGaps, Cases) {
  expect_cases(cases::surface_covered_gaps);
}
