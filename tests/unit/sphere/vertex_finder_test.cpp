#include "vertex_finder_cases.hpp"

#include "expect_cases.hpp"

TEST(VertexFinder, Cases) {
  expect_cases(cases::sphere_vertex_finder);
}
