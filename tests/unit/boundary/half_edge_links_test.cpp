#include "half_edge_links_cases.hpp"

#include "expect_cases.hpp"

TEST(HalfEdgeLinks, Cases) {
  expect_cases(cases::boundary_half_edge_links);
}
