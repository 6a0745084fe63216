#include "probe_grid_cases.hpp"

#include "expect_cases.hpp"

TEST(ProbeGrid, Cases) {
  expect_cases(cases::surface_probe_grid);
}
