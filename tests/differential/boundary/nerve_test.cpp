// Components, tunnels and voids of the closed balls as given: ties must not change them, however the balls are ordered.
#include <gtest/gtest.h>

#include "library_run.hpp"
#include "nerve.hpp"
#include "random_balls.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;

std::string topology_differs(const Balls &balls) {
  oracle::RandomSource random(21);
  const std::array<int64_t, 3> betti = oracle::nerve_betti_numbers(balls);
  for (int k = 0; k < 4; ++k) {
    const Balls mixed = k == 0 ? balls : oracle::permuted(balls, random.permutation(balls.size()));
    const hsp_boundary_counts counts = LibraryBoundary(mixed).counts();
    const int64_t tunnels = int64_t{counts.components} + counts.voids - counts.euler / 2;
    if (counts.components == betti[0] && counts.voids == betti[2] && tunnels == betti[1] && counts.euler % 2 == 0)
      continue;
    return "components, tunnels, voids " + std::to_string(counts.components) + " " + std::to_string(tunnels) + " " +
           std::to_string(counts.voids) + " instead of " + std::to_string(betti[0]) + " " + std::to_string(betti[1]) +
           " " + std::to_string(betti[2]);
  }
  return "";
}

TEST(Topology, IsThatOfTheNerve) {
  oracle::RandomSource random(22);
  std::array<int, 3> seen = {0, 0, 0};
  for (int k = 0; k < oracle::sets(10000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(1, 9)));
    ASSERT_EQ(complaint_about_smallest(balls, topology_differs), "");
    const std::array<int64_t, 3> betti = oracle::nerve_betti_numbers(balls);
    for (size_t d = 0; d < 3; ++d) seen[d] += betti[d] > (d == 0 ? 1 : 0) ? 1 : 0;
  }
  // The sets are interesting: several components, tunnels, and even voids occur.
  EXPECT_GT(seen[0], oracle::sets(1000));
  EXPECT_GT(seen[1], oracle::sets(200));
  if (oracle::sets_for_one == 1) {
    EXPECT_GT(seen[2], 5);
  }
}

TEST(Topology, OfCrownedBallsIsThatOfTheNerve) {
  oracle::RandomSource random(24);
  for (int k = 0; k < oracle::sets(300); ++k) {
    const Balls balls = oracle::crowned_balls(random, static_cast<size_t>(random.in(9, 26)));
    ASSERT_EQ(complaint_about_smallest(balls, topology_differs), "");
  }
}

// Eight balls at the corners of boxes close a void or just do not.
TEST(Topology, OfBoxesThatNearlyClose) {
  oracle::RandomSource random(23);
  int voids = 0;
  for (int k = 0; k < oracle::sets(500); ++k) {
    Balls balls;
    for (int64_t corner = 0; corner < 8; ++corner)
      balls.push_back({4 * (corner & 1), 6 * (corner >> 1 & 1), 12 * (corner >> 2), random.in(6, 7)});
    if (random.one_in(2)) balls.push_back({2, 3, 6, random.in(0, 1)});
    ASSERT_EQ(complaint_about_smallest(balls, topology_differs), "");
    voids += LibraryBoundary(balls).counts().voids > 0 ? 1 : 0;
  }
  if (oracle::sets_for_one == 1) {
    EXPECT_GT(voids, 0);
  }
}

}  // namespace
