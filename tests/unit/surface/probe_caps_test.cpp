#include "probe_caps_cases.hpp"

#include "expect_cases.hpp"

TEST(ProbeCaps, Cases) {
  expect_cases(cases::surface_probe_caps);
}
