#include "rows_cases.hpp"

#include "expect_cases.hpp"

TEST(Rows, Cases) {
  expect_cases(cases::core_rows);
}
