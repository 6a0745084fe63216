// The laws of cells notice tables that are broken. That whole ones obey them is seen with every set of the builder's
// tests.
#include "cells/free_space_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "built_free_space.hpp"
#include "point_lattices.hpp"

namespace {

using hsp::FreeSpaceInvariant;
using hsp::no_id;

// A cage with a void, whose facets have several free parts.
class FreeSpaceCheckTest : public testing::Test {
 protected:
  hsp::FreeSpaceViolation check() {
    return hsp::check_free_space(built_.balls(), built_.space(), built_.builder().scratch());
  }
  void expect(FreeSpaceInvariant invariant, uint32_t id) {
    EXPECT_EQ(check().invariant, invariant);
    EXPECT_EQ(check().id, id);
  }
  hsp::FreeSpace &space() { return built_.builder().structure(); }
  // A cell at a ball whose power cell has so many parts.
  uint32_t cell_with(bool several) {
    for (uint32_t c = space().run_count(); c < space().cell_count(); ++c) {
      if (space().landmarks_of(c).empty() != several && space().cell(c).kind == hsp::CellKind::at_ball) return c;
    }
    return no_id;
  }

  BuiltFreeSpace built_{oracle::cage_of_26(100, 75)};
};

TEST_F(FreeSpaceCheckTest, AcceptsWhatWasBuilt) {
  ASSERT_EQ(built_.status(), hsp::Status::ok);
  ASSERT_EQ(space().region_count(), 2U);
  expect(FreeSpaceInvariant::none, no_id);
}

TEST_F(FreeSpaceCheckTest, SeesACellOfAnotherBall) {
  const uint32_t c = cell_with(false);
  space().cells[c].ball = (space().cells[c].ball + 1) % 26;
  expect(FreeSpaceInvariant::records, c);
}

TEST_F(FreeSpaceCheckTest, SeesARunAmongParts) {
  const uint32_t c = cell_with(true);
  space().cells[c].kind = hsp::CellKind::run;
  expect(FreeSpaceInvariant::records, c);
}

TEST_F(FreeSpaceCheckTest, SeesALandmarkOfNoCell) {
  const uint32_t c = cell_with(true);
  space().cells[c].first_landmark = space().landmarks.size() + 1;
  EXPECT_EQ(check().invariant, FreeSpaceInvariant::records);
}

TEST_F(FreeSpaceCheckTest, SeesPartsThatAreNotThere) {
  uint32_t &end = space().first_part[space().cover.entries()];
  --end;
  expect(FreeSpaceInvariant::records, 0);
}

TEST_F(FreeSpaceCheckTest, SeesANeighbourOfOneSideOnly) {
  const uint32_t first = space().first_neighbour[3];
  space().neighbour[first] = space().cell_count() - 1;
  EXPECT_EQ(check().invariant, FreeSpaceInvariant::neighbours);
}

TEST_F(FreeSpaceCheckTest, SeesAListBehindItsEnd) {
  space().first_neighbour[5] = space().first_neighbour[7] + 1;
  EXPECT_EQ(check().invariant, FreeSpaceInvariant::neighbours);
}

TEST_F(FreeSpaceCheckTest, SeesAPairThatIsNoNeighbour) {
  auto &pair = space().contacts[11];
  pair.cell[1] = pair.cell[0];
  expect(FreeSpaceInvariant::neighbours, pair.cell[0]);
}

TEST_F(FreeSpaceCheckTest, SeesAWrongRegion) {
  const uint32_t c = cell_with(true);
  space().cells[c].region ^= 1U;
  expect(FreeSpaceInvariant::regions, c);
}

TEST_F(FreeSpaceCheckTest, SeesARegionTooMany) {
  ++space().regions;
  expect(FreeSpaceInvariant::regions, space().cell_count());
}

TEST_F(FreeSpaceCheckTest, SeesAPowerCellTooMany) {
  ++space().power_cells;
  expect(FreeSpaceInvariant::power_cells, space().cube_count());
}

TEST_F(FreeSpaceCheckTest, SeesAPartThatMeetsItsBallSaidToBeApart) {
  const uint32_t c = cell_with(false);
  space().cells[c].kind = hsp::CellKind::apart;
  expect(FreeSpaceInvariant::power_cells, space().cells[c].cube);
}

TEST_F(FreeSpaceCheckTest, SeesALandmarkThatChangedItsCell) {
  uint32_t c = cell_with(true);
  while (space().landmarks_of(c).empty() || space().landmarks_of(c + 1).size() < 2) ++c;
  ++space().cells[c + 1].first_landmark;
  expect(FreeSpaceInvariant::power_cells, space().cells[c].cube);
}

// Two cells that trade their neighbours: each is still seen from both sides.
TEST_F(FreeSpaceCheckTest, SeesNeighboursThatAreNotAcross) {
  uint32_t a = space().run_count(), b = no_id;
  for (uint32_t c = a + 1; c < space().cell_count() && b == no_id; ++c) {
    const bool alike = space().neighbours(c).size() == space().neighbours(a).size();
    const bool far = space().cell(c).cube != space().cell(a).cube;
    if (alike && far && space().cell(c).region == space().cell(a).region) b = c;
  }
  ASSERT_NE(b, no_id);
  const auto traded = [&](uint32_t c) { return c == a ? b : c == b ? a : c; };
  for (auto &pair : space().contacts.items()) pair = {{traded(pair.cell[0]), traded(pair.cell[1])}};
  for (uint32_t k = 0; k < space().neighbour.size(); ++k) space().neighbour[k] = traded(space().neighbour[k]);
  for (uint32_t k = 0; k < space().neighbours(a).size(); ++k) {
    std::swap(space().neighbour[space().first_neighbour[a] + k], space().neighbour[space().first_neighbour[b] + k]);
  }
  for (uint32_t c = 0; c < space().cell_count(); ++c) {
    const auto list = space().neighbours(c);
    std::sort(space().neighbour.data() + space().first_neighbour[c],
              space().neighbour.data() + space().first_neighbour[c] + list.size());
  }
  EXPECT_EQ(check().invariant, FreeSpaceInvariant::facets);
}

}  // namespace
