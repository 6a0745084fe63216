#include "region_pieces_cases.hpp"

#include "expect_cases.hpp"

TEST(RegionPieces, Cases) {
  expect_cases(cases::surface_region_pieces);
}
