#include "half_edges_cases.hpp"

#include "expect_cases.hpp"

TEST(HalfEdges, Cases) {
  expect_cases(cases::sphere_half_edges);
}
