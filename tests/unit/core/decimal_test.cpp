#include "decimal_cases.hpp"

#include "expect_cases.hpp"

TEST(Decimal, Cases) {
  expect_cases(cases::core_decimal);
}
