#include "shading_cases.hpp"

#include "expect_cases.hpp"

TEST(Shading, Cases) {
  expect_cases(cases::picture_shading);
}
