#include "lattice_ball_cases.hpp"

#include "expect_cases.hpp"

TEST(LatticeBall, Cases) {
  expect_cases(cases::exact_lattice_ball);
}
