#include "boundary_positions_cases.hpp"

#include "expect_cases.hpp"

TEST(BoundaryPositions, Cases) {
  expect_cases(cases::measure_boundary_positions);
}
