#include "front_cases.hpp"

#include "expect_cases.hpp"

TEST(Front, Cases) {
  expect_cases(cases::surface_front);
}
