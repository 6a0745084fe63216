#include "piece_arcs_cases.hpp"

#include "expect_cases.hpp"

TEST(PieceArcs, Cases) {
  expect_cases(cases::view_piece_arcs);
}
