#include "input_order_cases.hpp"

#include "expect_cases.hpp"

TEST(InputOrder, Cases) {
  expect_cases(cases::measure_input_order);
}
