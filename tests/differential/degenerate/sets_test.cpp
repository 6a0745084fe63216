// The library on the corpus of degenerate sets: topology, areas and volumes against what is known by construction and
// against the oracles; and nothing depends on order, place, scale, axes and copies.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "brute_boundary.hpp"
#include "computed_balls.hpp"
#include "corpus_expectations.hpp"

namespace {

using degenerate::DegenerateSet;
using degenerate::Topology;

TEST(DegenerateSets, AreManyAndOfEveryKind) {
  std::set<std::string> names;
  for (const DegenerateSet &set : degenerate::corpus()) EXPECT_TRUE(names.insert(set.name).second) << set.name;
  EXPECT_GE(names.size(), 250U);
  for (const char *kind : {"duplicates",
                           "concentric",
                           "contained",
                           "tangent outside",
                           "tangent inside",
                           "through a point",
                           "circles touch on a sphere",
                           "through a circle",
                           "coplanar",
                           "collinear",
                           "hexagon",
                           "void",
                           "radius 0",
                           "radii 1:1000",
                           "largest radius",
                           "farthest corner",
                           "a million away",
                           "named: benzene",
                           "named: hollow shell",
                           "named: belt",
                           "lattice",
                           "slanted lattice",
                           "face-centred lattice",
                           "diamond",
                           "fullerene",
                           "ring",
                           "shell",
                           "belt",
                           "face with"}) {
    const auto same_start = [&](const std::string &name) { return name.starts_with(kind); };
    EXPECT_GE(std::count_if(names.begin(), names.end(), same_start), 2) << kind;
  }
}

TEST(DegenerateSets, HaveTheTopologyThatIsKnown) {
  for (const DegenerateSet &set : degenerate::corpus()) {
    if (!set.expected) continue;
    // At the set's own step.
    EXPECT_EQ(degenerate::to_text(degenerate::topology_of(LibraryBoundary(set.balls, set.step))),
              degenerate::to_text(*set.expected))
        << set.name;
    const bool nerve = set.source == "nerve";
    if (nerve) {
      EXPECT_EQ(degenerate::to_text(degenerate::topology_of_nerve(set.balls)), degenerate::to_text(*set.expected))
          << set.name;
    }
    if (set.source == "brute force") {
      EXPECT_EQ(degenerate::to_text(degenerate::topology_of(oracle::brute_boundary(set.balls))),
                degenerate::to_text(*set.expected))
          << set.name;
    }
  }
}

TEST(DegenerateSets, HaveTheTopologyOfTheNerve) {
  degenerate::expect_of_all(0, 12, degenerate::nerve_disagrees);
}
TEST(DegenerateSets, HaveTheBoundaryOfBruteForce) {
  degenerate::expect_of_all(0, 36, degenerate::brute_force_disagrees);
}
TEST(DegenerateSets, HaveTheAreasAndVolumesOfSlices) {
  degenerate::expect_of_all(1, 20, degenerate::slices_disagree);
}
TEST(DegenerateSets, KeepTheInvariants) {
  degenerate::expect_of_all(0, 1000, boundary_invariant_broken);
}
TEST(DegenerateSets, DoNotDependOnTheOrder) {
  degenerate::expect_of_all(0, 1000, degenerate::orders_disagree);
}
TEST(DegenerateSets, DoNotDependOnThePlace) {
  degenerate::expect_of_all(0, 1000, degenerate::places_disagree);
}
TEST(DegenerateSets, DoNotDependOnTheScale) {
  degenerate::expect_of_all(0, 1000, degenerate::scales_disagree);
}
TEST(DegenerateSets, DoNotDependOnTheAxes) {
  degenerate::expect_of_all(0, 1000, degenerate::axes_disagree);
}
TEST(DegenerateSets, DoNotDependOnCopies) {
  degenerate::expect_of_all(0, 1000, degenerate::copies_disagree);
}

// Loops of the faces of ball 0, most first.
std::vector<uint32_t> loops_of_first_ball(const std::string &name) {
  std::vector<uint32_t> loops;
  for (const DegenerateSet &set : degenerate::corpus()) {
    if (set.name != name) continue;
    for (const hsp_face &face : LibraryBoundary(set.balls).faces())
      if (face.ball == 0) loops.push_back(face.loops);
  }
  std::sort(loops.rbegin(), loops.rend());
  return loops;
}

TEST(DegenerateSets, HaveFacesWithManyHoles) {
  using Loops = std::vector<uint32_t>;
  EXPECT_EQ(loops_of_first_ball("belt of 20 separate balls"), (Loops{20}));
  EXPECT_EQ(loops_of_first_ball("belt of 20 balls"), (Loops{1, 1}));
  // Three bumps in the northern face, two in the southern.
  EXPECT_EQ(loops_of_first_ball("belt of 20 balls, bumps at both poles and beside them"), (Loops{4, 3}));
  EXPECT_EQ(loops_of_first_ball("face with 30 holes"), (Loops{30}));
  EXPECT_EQ(loops_of_first_ball("face with 54 holes"), (Loops{54}));
  EXPECT_EQ(loops_of_first_ball("face with 102 holes"), (Loops{102}));
}

}  // namespace
