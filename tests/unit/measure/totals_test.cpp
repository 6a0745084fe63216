#include "totals_cases.hpp"

#include "expect_cases.hpp"

TEST(Totals, Cases) {
  expect_cases(cases::measure_totals);
}
