// The laws of cells notice tables that are broken. That whole ones obey them is seen with every set of the builder's
// tests.
#include "cells/free_space_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

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

  // One number is wrong for a while.
  template <class Number>
  void expect(Number &number, Number wrong, FreeSpaceInvariant invariant, uint32_t id) {
    const Number right = std::exchange(number, wrong);
    expect(invariant, id);
    number = right;
  }

  using Lists = std::vector<std::vector<uint32_t>>;
  // The lists from the pairs.
  Lists neighbour_lists() {
    Lists lists(space().cell_count());
    for (const auto &pair : space().contacts.items()) {
      lists[pair.cell[0]].push_back(pair.cell[1]);
      lists[pair.cell[1]].push_back(pair.cell[0]);
    }
    for (auto &list : lists) std::sort(list.begin(), list.end());
    return lists;
  }
  void store(const Lists &lists) {
    uint32_t at = 0;
    for (uint32_t c = 0; c < lists.size(); ++c) {
      space().first_neighbour[c] = at;
      for (const uint32_t other : lists[c]) space().neighbour[at++] = other;
    }
    space().first_neighbour[space().cell_count()] = at;
  }
  void list_neighbours() { store(neighbour_lists()); }

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
  const uint32_t a = cell_with(false);
  uint32_t b = a + 1;
  while (space().cell(b).cube == space().cell(a).cube || space().cell(b).region != space().cell(a).region) ++b;
  const auto traded = [&](uint32_t c) { return c == a ? b : c == b ? a : c; };
  for (auto &pair : space().contacts.items()) pair = {{traded(pair.cell[0]), traded(pair.cell[1])}};
  list_neighbours();
  EXPECT_EQ(check().invariant, FreeSpaceInvariant::facets);
}

// A pair more, of cells of two cubes without a common side.
TEST_F(FreeSpaceCheckTest, SeesANeighbourTooMany) {
  const uint32_t a = cell_with(false);
  const auto &at = space().cover.cube(space().cell(a).cube);
  uint32_t b = a + 1;
  while (space().cover.cube(space().cell(b).cube).z < at.z + 2 || space().cell(b).region != space().cell(a).region) ++b;
  space().contacts.push({{a, b}});
  list_neighbours();
  expect(FreeSpaceInvariant::facets, a);
}

// A pair less, of cells that are still joined by others.
TEST_F(FreeSpaceCheckTest, SeesANeighbourThatIsMissing) {
  const auto several = [&](uint32_t c) { return c >= space().run_count() && space().neighbours(c).size() > 4; };
  uint32_t k = 0;
  while (!several(space().contacts[k].cell[0]) || !several(space().contacts[k].cell[1])) ++k;
  const uint32_t last = space().contacts.size() - 1;
  space().contacts[k] = space().contacts[last];
  space().contacts.shrink(last);
  list_neighbours();
  EXPECT_EQ(check().invariant, FreeSpaceInvariant::facets);
}

// The first and the last one, too.
TEST_F(FreeSpaceCheckTest, SeesEveryCellThatIsWrong) {
  const uint32_t cells = space().cell_count(), runs = space().run_count();
  for (uint32_t c = 0; c < cells; ++c) {
    hsp::FreeCell &cell = space().cells[c];
    expect(cell.region, space().region_count(), FreeSpaceInvariant::records, c);
    expect(cell.region, cell.region ^ 1U, FreeSpaceInvariant::regions, c);
    if (c >= runs) expect(cell.ball, (cell.ball + 1) % 26, FreeSpaceInvariant::records, c);
    if (c + 1 < cells) {
      expect(space().first_neighbour[c + 1], 2 * space().adjacency_count() + 1, FreeSpaceInvariant::neighbours, c);
    }
  }
  for (auto &pair : space().contacts.items()) {
    expect(pair.cell[1], pair.cell[0], FreeSpaceInvariant::neighbours, pair.cell[0]);
  }
}

// Of the first cell and of the last one, at the ends of their lists.
TEST_F(FreeSpaceCheckTest, SeesAStrangerAtEitherEndOfAList) {
  const Lists right = neighbour_lists();
  const uint32_t last = space().cell_count() - 1;
  Lists lists = right;
  lists[0].front() = 0;
  store(lists);
  expect(FreeSpaceInvariant::neighbours, 0);
  lists = right;
  ASSERT_LT(lists[0].back(), last);
  lists[0].back() = last;
  store(lists);
  expect(FreeSpaceInvariant::neighbours, 0);
  // In place of one neighbour, which does not know the last cell any more, two others.
  lists = right;
  const uint32_t gone = lists[last].back();
  std::erase(lists[gone], last);
  lists[last].pop_back();
  for (uint32_t stranger = 0, count = 0; count < 2; ++stranger) {
    if (std::count(right[last].begin(), right[last].end(), stranger) > 0) continue;
    lists[last].push_back(stranger);
    ++count;
  }
  std::sort(lists[last].begin(), lists[last].end());
  store(lists);
  expect(FreeSpaceInvariant::neighbours, last);
  store(right);
  expect(FreeSpaceInvariant::none, no_id);
}

}  // namespace
