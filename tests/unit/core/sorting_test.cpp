#include "sorting_cases.hpp"

#include "expect_cases.hpp"

TEST(Sorting, Cases) {
  expect_cases(cases::core_sorting);
}
