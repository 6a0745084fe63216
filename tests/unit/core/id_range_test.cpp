#include "id_range_cases.hpp"

#include "expect_cases.hpp"

TEST(IdRange, Cases) {
  expect_cases(cases::core_id_range);
}
