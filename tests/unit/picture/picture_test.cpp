#include "picture_cases.hpp"

#include "expect_cases.hpp"

TEST(Picture, Cases) {
  expect_cases(cases::picture_picture);
}
