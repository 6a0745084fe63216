#include "projected_arcs_cases.hpp"

#include "expect_cases.hpp"

TEST(ProjectedArcs, Cases) {
  expect_cases(cases::view_projected_arcs);
}
