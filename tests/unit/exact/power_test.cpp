#include "power_cases.hpp"

#include "expect_cases.hpp"

TEST(Power, Cases) {
  expect_cases(cases::exact_power);
}
