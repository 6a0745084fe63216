#include "tangency_cases.hpp"

#include "expect_cases.hpp"

TEST(Tangency, Cases) {
  expect_cases(cases::measure_tangency);
}
