#include "boundary_cases.hpp"

#include "expect_cases.hpp"

TEST(Boundary, Cases) {
  expect_cases(cases::boundary_boundary);
}
