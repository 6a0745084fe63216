#include "exterior_angles_cases.hpp"

#include "expect_cases.hpp"

TEST(ExteriorAngles, Cases) {
  expect_cases(cases::measure_exterior_angles);
}
