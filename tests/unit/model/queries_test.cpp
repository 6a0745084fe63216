#include "queries_cases.hpp"

#include "expect_cases.hpp"

TEST(Queries, Cases) {
  expect_cases(cases::model_queries);
}
TEST(Queries, CasesForTheBaseline) {
  for (const bool in_lanes : {hsp::has_lanes, false}) {
    cases::small_grid().use(hsp::Target::baseline, in_lanes);
    expect_cases(cases::model_queries);
  }
  cases::small_grid().use_own_code();
}
