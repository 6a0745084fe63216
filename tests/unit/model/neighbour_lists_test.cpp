#include "neighbour_lists_cases.hpp"

#include "expect_cases.hpp"

TEST(NeighbourLists, Cases) {
  expect_cases(cases::model_neighbour_lists);
}
TEST(NeighbourLists, CasesWithoutWideCode) {
  cases::small_grid().set_wide(false);
  expect_cases(cases::model_neighbour_lists);
  cases::small_grid().set_wide(true);
}
