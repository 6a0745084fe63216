#include "term_ranges_cases.hpp"

#include "expect_cases.hpp"

TEST(TermRanges, Cases) {
  expect_cases(cases::core_term_ranges);
}
