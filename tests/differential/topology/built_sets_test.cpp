// Shells in shells, rings and cages have the components, genera, voids and nesting they were built with; sets that are
// awkward to cut keep all invariants, in any order and along any axes.
#include <gtest/gtest.h>

#include "cell_comparison.hpp"
#include "nested_balls.hpp"
#include "set_arrangements.hpp"
#include "smallest_failing.hpp"
#include "topology_complaints.hpp"

namespace {

using oracle::Balls;

std::vector<Balls> orders_of(const Balls &balls) {
  oracle::RandomSource random(balls.size());
  return {balls, Balls(balls.rbegin(), balls.rend()), oracle::permuted(balls, random.permutation(balls.size()))};
}

// The library's component of a built one.
uint32_t component_of(const LibraryTopology &topology, const Balls &all, const BuiltComponent &built) {
  const std::vector<hsp_ball> records = topology.boundary().balls();
  for (size_t i = 0; i < all.size(); ++i)
    if (all[i] == built.balls.front()) return records[i].component;
  return HSP_NONE;
}

void expect_as_built(const BuiltSet &set, const Balls &balls) {
  const LibraryTopology topology(balls);
  ASSERT_EQ(topology.counts().components, set.components.size()) << set.name;
  const auto components = topology.components();
  const auto shells = topology.shells();
  const auto cells = topology.cells();
  std::vector<uint32_t> found;
  for (const BuiltComponent &built : set.components) found.push_back(component_of(topology, balls, built));
  uint32_t voids = 0;
  for (size_t k = 0; k < found.size(); ++k) {
    const BuiltComponent &built = set.components[k];
    ASSERT_LT(found[k], components.size()) << set.name;
    const hsp_component &component = components[found[k]];
    EXPECT_EQ(component.balls, built.balls.size()) << set.name << ", component " << k;
    EXPECT_EQ(component.shells, 1 + built.voids) << set.name << ", component " << k;
    uint32_t genus = 0;
    for (const hsp_shell &shell : shells) genus += shell.component == found[k] ? shell.genus : 0;
    EXPECT_EQ(genus, built.genus) << set.name << ", component " << k;
    voids += built.voids;
    const uint32_t expected = built.around ? found[*built.around] : HSP_NONE;
    const uint32_t around =
        component.region == 0 ? HSP_NONE : shells[cells[component.region].enclosing_shell].component;
    EXPECT_EQ(around, expected) << set.name << ", component " << k << " lies in the void of another";
  }
  EXPECT_EQ(topology.counts().regions, 1 + voids) << set.name;
}

TEST(BuiltSets, AreAsBuilt) {
  for (const BuiltSet &set : built_sets())
    for (const Balls &order : orders_of(set.balls())) expect_as_built(set, order);
}

TEST(BuiltSets, AreAsBuiltAlongAllAxes) {
  for (const BuiltSet &set : built_sets())
    for (size_t image = 0; image < 6; ++image) {
      BuiltSet turned = set;
      for (BuiltComponent &component : turned.components) component.balls = oracle::axis_images(component.balls)[image];
      expect_as_built(turned, turned.balls());
    }
}

TEST(BuiltSets, KeepTheInvariants) {
  for (const BuiltSet &set : built_sets()) {
    EXPECT_EQ(topology_invariant_broken(set.balls()), "") << set.name;
    EXPECT_EQ(topology_orders_disagree(set.balls()), "") << set.name;
  }
}

// The built topology is the oracle's; without it a shell that does not close would go unnoticed here.
TEST(BuiltSets, AreNestedAsTheDualComplexHasIt) {
  int compared = 0;
  for (const BuiltSet &set : built_sets()) {
    const Balls balls = set.balls();
    if (!small_enough_for_dual_complex(balls)) continue;
    EXPECT_EQ(nesting_disagrees(balls), "") << set.name;
    EXPECT_EQ(locations_disagree(balls, 60, balls.size()), "") << set.name;
    ++compared;
  }
  EXPECT_GE(compared, 12);
}

// The points of a void belong to it, those between two shells to the cell between them.
TEST(BuiltSets, CellsFromTheInsideOut) {
  const BuiltSet set = built_sets().front();
  ASSERT_EQ(set.name, "four shells, one in another");
  const LibraryTopology topology(set.balls());
  const auto components = topology.components();
  const auto cells = topology.cells();
  const auto shells = topology.shells();
  // 0 is inside the first shell, 6 between it and the second, and so on.
  std::vector<uint32_t> walls;
  for (const int64_t x : {0, 6, 60, 600}) {
    for (const oracle::LatticePoint &point :
         {oracle::LatticePoint{x, 0, 0}, {-x, 0, 0}, {0, x, 0}, {0, -x, 0}, {0, 0, x}, {0, 0, -x}}) {
      const uint32_t cell = topology.cell_of(point);
      ASSERT_NE(cell, 0U) << x;
      ASSERT_LT(cell, cells.size()) << x;
      if (walls.empty() || walls.back() != cells[cell].enclosing_shell) walls.push_back(cells[cell].enclosing_shell);
      EXPECT_EQ(cell, topology.cell_of({x, 0, 0}));
    }
    EXPECT_EQ(cells[topology.cell_of({x, 0, 0})].components, x == 0 ? 0U : 1U);
  }
  EXPECT_EQ(topology.cell_of({0, 0, 3000}), 0U);
  ASSERT_EQ(walls.size(), 4U);
  for (size_t k = 0; k + 1 < walls.size(); ++k)
    EXPECT_EQ(components[shells[walls[k]].component].region, shells[walls[k + 1]].region);
}

TEST(AwkwardSets, KeepTheInvariantsInAnyOrderAndAlongAnyAxes) {
  for (const oracle::NamedBalls &set : awkward_sets()) {
    EXPECT_EQ(complaint_about_smallest(set.balls, topology_invariant_broken), "") << set.name;
    EXPECT_EQ(complaint_about_smallest(set.balls, topology_orders_disagree), "") << set.name;
    for (const Balls &turned : oracle::axis_images(set.balls))
      EXPECT_EQ(complaint_about_smallest(turned, topology_invariant_broken), "") << set.name;
  }
}

TEST(AwkwardSets, AreNestedAsTheDualComplexHasIt) {
  int compared = 0;
  for (const oracle::NamedBalls &set : awkward_sets()) {
    if (!small_enough_for_dual_complex(set.balls)) continue;
    EXPECT_EQ(nesting_disagrees(set.balls), "") << set.name;
    EXPECT_EQ(locations_disagree(set.balls, 60, set.balls.size()), "") << set.name;
    ++compared;
  }
  EXPECT_GE(compared, 30);
}

}  // namespace
