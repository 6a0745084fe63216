#include "query_hits_cases.hpp"

#include "expect_cases.hpp"

TEST(QueryHits, Cases) {
  expect_cases(cases::model_query_hits);
}
