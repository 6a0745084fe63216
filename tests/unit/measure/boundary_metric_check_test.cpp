#include "boundary_metric_check_cases.hpp"

#include "expect_cases.hpp"

TEST(BoundaryMetricCheck, Cases) {
  expect_cases(cases::measure_boundary_metric_check);
}
