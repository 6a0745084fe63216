// The invariants of boundaries, their positions, angles and circles among them, over random and awkward sets.
#include <gtest/gtest.h>

#include "computed_balls.hpp"
#include "named_balls.hpp"
#include "random_balls.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::RandomSource;

TEST(BoundaryInvariants, OfRandomSets) {
  RandomSource random(51);
  for (int k = 0; k < oracle::sets(4000); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 25)));
    ASSERT_EQ(complaint_about_smallest(balls, boundary_invariant_broken), "");
  }
}

TEST(BoundaryInvariants, OfDegenerateSets) {
  RandomSource random(52);
  for (int k = 0; k < oracle::sets(8000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(2, 14)));
    ASSERT_EQ(complaint_about_smallest(balls, boundary_invariant_broken), "");
  }
}

TEST(BoundaryInvariants, OfCrownedSets) {
  RandomSource random(53);
  for (int k = 0; k < oracle::sets(1000); ++k)
    ASSERT_EQ(complaint_about_smallest(oracle::crowned_balls(random, 25), boundary_invariant_broken), "");
}

TEST(BoundaryInvariants, OfNamedSets) {
  for (const oracle::KnownBalls &set : oracle::known_balls())
    EXPECT_EQ(complaint_about_smallest(set.balls, boundary_invariant_broken), "") << set.name;
}

}  // namespace
