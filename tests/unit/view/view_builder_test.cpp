#include "view_builder_cases.hpp"

#include "expect_cases.hpp"

TEST(ViewBuilder, Cases) {
  expect_cases(cases::view_view_builder);
}
