#include "rank_cases.hpp"

#include "expect_cases.hpp"

TEST(Rank, Cases) {
  expect_cases(cases::exact_rank);
}
