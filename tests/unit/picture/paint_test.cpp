#include "paint_cases.hpp"

#include "expect_cases.hpp"

TEST(Paint, Cases) {
  expect_cases(cases::picture_paint);
}
