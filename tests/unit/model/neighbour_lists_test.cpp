#include "neighbour_lists_cases.hpp"

#include "expect_cases.hpp"

TEST(NeighbourLists, Cases) {
  expect_cases(cases::model_neighbour_lists);
}
