#include "saddle_cases.hpp"

#include "expect_cases.hpp"

TEST(Saddle, Cases) {
  expect_cases(cases::surface_saddle);
}
