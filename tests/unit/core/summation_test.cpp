#include "summation_cases.hpp"

#include "expect_cases.hpp"

TEST(Summation, Cases) {
  expect_cases(cases::core_summation);
}
