#include "view_cases.hpp"

#include "expect_cases.hpp"

TEST(View, Cases) {
  expect_cases(cases::view_view);
}
