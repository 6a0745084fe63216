// Sets without ties, in which areas of simple faces and directions of edges are defined: random sets whose centres are
// shifted by less than a hundredth of their radii.
#include <gtest/gtest.h>

#include "random_balls.hpp"
#include "smallest_failing.hpp"
#include "topology_complaints.hpp"
#include "topology_run.hpp"

namespace {

using oracle::Balls;
using oracle::RandomSource;

Balls jittered(const Balls &balls, RandomSource &random) {
  Balls result;
  for (const oracle::LatticeBall &b : balls)
    result.push_back({100000 * b.x + random.in(-50000, 50000), 100000 * b.y + random.in(-50000, 50000),
                      100000 * b.z + random.in(-50000, 50000), 100000 * b.radius + random.in(0, 50000)});
  return result;
}

using Maker = Balls (*)(RandomSource &, size_t);

void expect_invariants(Maker make, int sets, int64_t least, int64_t most) {
  RandomSource random(91);
  uint32_t cut = 0;
  for (int k = 0; k < sets; ++k) {
    const Balls balls = jittered(make(random, static_cast<size_t>(random.in(least, most))), random);
    ASSERT_EQ(complaint_about_smallest(balls, topology_invariant_broken), "");
    cut += LibraryTopology(balls).counts().cut_edges;
  }
  EXPECT_GT(cut, 0U);
}

TEST(GeneralPosition, LooseBalls) {
  expect_invariants(oracle::loose_balls, 500, 2, 40);
}
TEST(GeneralPosition, DenseBalls) {
  expect_invariants(oracle::dense_balls, 300, 2, 20);
}
TEST(GeneralPosition, ClusteredBalls) {
  expect_invariants(oracle::clustered_balls, 500, 2, 40);
}
TEST(GeneralPosition, BeltedBalls) {
  expect_invariants(oracle::belted_balls, 500, 9, 45);
}
TEST(GeneralPosition, CrownedBalls) {
  expect_invariants(oracle::crowned_balls, 500, 9, 45);
}
TEST(GeneralPosition, DegenerateBallsJustOffTheirTies) {
  expect_invariants(oracle::degenerate_balls, 1000, 2, 14);
}

}  // namespace
