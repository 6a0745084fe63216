#include "view_rotation_cases.hpp"

#include "expect_cases.hpp"

TEST(ViewRotation, Cases) {
  expect_cases(cases::view_view_rotation);
}
