#include "queries_cases.hpp"

#include "expect_cases.hpp"

TEST(Queries, Cases) {
  expect_cases(cases::model_queries);
}
