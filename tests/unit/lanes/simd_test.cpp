#include "simd_cases.hpp"

#include "expect_cases.hpp"

TEST(Simd, Cases) {
  expect_cases(cases::lanes_simd);
}
