#include "disjoint_sets_cases.hpp"

#include "expect_cases.hpp"

TEST(DisjointSets, Cases) {
  expect_cases(cases::core_disjoint_sets);
}
