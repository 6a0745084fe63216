#include "packing_statistics_cases.hpp"

#include "expect_cases.hpp"

TEST(PackingStatistics, Cases) {
  expect_cases(cases::model_packing_statistics);
}
