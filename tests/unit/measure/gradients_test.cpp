#include "gradients_cases.hpp"

#include "expect_cases.hpp"

TEST(Gradients, Cases) {
  expect_cases(cases::measure_gradients);
}
