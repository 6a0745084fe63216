// Which component lies in which void, which balls line a cell, and where points lie, against the dual complex; sets
// with many shells and sets full of ties.
#include <gtest/gtest.h>

#include <array>

#include "cell_comparison.hpp"
#include "nested_balls.hpp"
#include "set_arrangements.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"
#include "topology_complaints.hpp"

namespace {

using oracle::Balls;

std::string nesting_or_invariants(const Balls &balls) {
  const std::string complaint = nesting_disagrees(balls);
  return complaint.empty() ? topology_invariant_broken(balls) : complaint;
}

std::string locations_of(const Balls &balls) {
  return locations_disagree(balls, 40, 51);
}

TEST(Nesting, OfShellsInShells) {
  oracle::RandomSource random(52);
  int components_in_voids = 0;
  int deep = 0;
  for (int k = 0; k < oracle::sets(400); ++k) {
    const Balls balls = nested_balls(random);
    ASSERT_TRUE(small_enough_for_dual_complex(balls)) << oracle::to_text(balls);
    ASSERT_EQ(complaint_about_smallest(balls, nesting_or_invariants), "");
    const LibraryTopology topology(balls);
    const auto cells = topology.cells();
    const auto shells = topology.shells();
    const auto components = topology.components();
    for (const hsp_component &component : components) {
      if (component.region == 0) continue;
      ++components_in_voids;
      deep += components[shells[cells[component.region].enclosing_shell].component].region != 0 ? 1 : 0;
    }
  }
  // The sets are what they are meant to be.
  EXPECT_GT(components_in_voids, oracle::sets(150));
  EXPECT_GT(deep, oracle::sets(20));
}

TEST(Nesting, OfDegenerateSets) {
  oracle::RandomSource random(53);
  for (int k = 0; k < oracle::sets(3000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(2, 12)));
    ASSERT_EQ(complaint_about_smallest(balls, nesting_disagrees), "");
  }
}

// Balls that line a cell are compared where no ties leave open whether a ball has a face there.
TEST(CellBalls, OfShellsInShells) {
  oracle::RandomSource random(58);
  int voids = 0;
  int with_several_faces = 0;
  for (int k = 0; k < oracle::sets(200); ++k) {
    Balls balls = oracle::scaled(nested_balls(random), 250);
    for (oracle::LatticeBall &b : balls)
      b = {b.x + random.in(-100, 100), b.y + random.in(-100, 100), b.z + random.in(-100, 100),
           b.radius + random.in(0, 50)};
    const LibraryTopology topology(balls);
    ASSERT_EQ(cell_balls_disagree(topology, oracle::DualComplex(balls)), "") << oracle::to_text(balls);
    voids += static_cast<int>(topology.cells().size()) - 1;
    for (const hsp_ball &ball : topology.boundary().balls()) with_several_faces += ball.faces > 1 ? 1 : 0;
  }
  EXPECT_GT(voids, oracle::sets(200));
  EXPECT_GT(with_several_faces, oracle::sets(1000));
}

TEST(Location, InShellsInShells) {
  oracle::RandomSource random(54);
  for (int k = 0; k < oracle::sets(400); ++k)
    ASSERT_EQ(complaint_about_smallest(nested_balls(random), locations_of), "");
}

TEST(Location, InDegenerateSets) {
  oracle::RandomSource random(55);
  for (int k = 0; k < oracle::sets(2500); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(1, 12)));
    ASSERT_EQ(complaint_about_smallest(balls, locations_of), "");
  }
}

// Eight balls at the corners of a box, in which vertical rays from the middle meet ties: two of its sides are closed by
// single points.
TEST(Location, InBoxesThatNearlyClose) {
  oracle::RandomSource random(56);
  constexpr std::array<std::array<int64_t, 3>, 3> boxes = {{{6, 6, 8}, {6, 8, 6}, {8, 6, 6}}};
  for (int k = 0; k < oracle::sets(300); ++k) {
    const auto &sides = boxes[static_cast<size_t>(random.in(0, 2))];
    Balls balls;
    for (int64_t corner = 0; corner < 8; ++corner)
      balls.push_back(
          {sides[0] * (corner & 1), sides[1] * (corner >> 1 & 1), sides[2] * (corner >> 2), random.one_in(12) ? 4 : 5});
    if (random.one_in(2)) balls.push_back({sides[0] / 2, sides[1] / 2, sides[2] / 2, 0});
    // Copies above, through whose walls rays go on.
    if (random.one_in(2))
      for (size_t i = 0; i < 8; ++i) balls.push_back({balls[i].x, balls[i].y, balls[i].z + 20, balls[i].radius});
    ASSERT_EQ(complaint_about_smallest(balls, [](const Balls &set) { return locations_disagree(set, 150, 57); }), "");
    ASSERT_EQ(complaint_about_smallest(balls, nesting_or_invariants), "");
  }
}

}  // namespace
