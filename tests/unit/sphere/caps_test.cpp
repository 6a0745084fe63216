#include "caps_cases.hpp"

#include "expect_cases.hpp"

TEST(Caps, Cases) {
  expect_cases(cases::sphere_caps);
}
