#include "traversal_cases.hpp"

#include "expect_cases.hpp"

TEST(Traversal, Cases) {
  expect_cases(cases::topology_traversal);
}
