#include "fixed_vector_cases.hpp"

#include "expect_cases.hpp"

TEST(FixedVector, Cases) {
  expect_cases(cases::core_fixed_vector);
}
