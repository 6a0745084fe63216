#include "row_directory_cases.hpp"

#include "expect_cases.hpp"

TEST(RowDirectory, Cases) {
  expect_cases(cases::model_row_directory);
}
