#include "first_index_cases.hpp"

#include "expect_cases.hpp"

TEST(FirstIndex, Cases) {
  expect_cases(cases::core_first_index);
}
