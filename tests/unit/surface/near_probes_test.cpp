#include "near_probes_cases.hpp"

#include "expect_cases.hpp"

TEST(NearProbes, Cases) {
  expect_cases(cases::surface_near_probes);
}
