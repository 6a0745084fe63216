#include "shells_cases.hpp"

#include "expect_cases.hpp"

TEST(Shells, Cases) {
  expect_cases(cases::boundary_shells);
}
