#include "areas_cases.hpp"

#include "expect_cases.hpp"

TEST(Areas, Cases) {
  expect_cases(cases::measure_areas);
}
