#include "positions_cases.hpp"

#include "expect_cases.hpp"

TEST(Positions, Cases) {
  expect_cases(cases::topology_positions);
}
