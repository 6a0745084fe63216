#include "exact_predicates_cases.hpp"

#include "expect_cases.hpp"

TEST(ExactPredicates, Cases) {
  expect_cases(cases::exact_exact_predicates);
}
