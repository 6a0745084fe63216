#include "visible_piece_cases.hpp"

#include "expect_cases.hpp"

TEST(VisiblePiece, Cases) {
  expect_cases(cases::view_visible_piece);
}
