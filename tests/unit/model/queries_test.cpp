#include "queries_cases.hpp"

#include "expect_cases.hpp"

TEST(Queries, Cases) {
  expect_cases(cases::model_queries);
}
TEST(Queries, CasesWithoutWideCode) {
  cases::small_grid().set_wide(false);
  expect_cases(cases::model_queries);
  cases::small_grid().set_wide(true);
}
