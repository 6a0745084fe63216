// The comparisons of this folder on many more and larger sets.
#include <gtest/gtest.h>

#include "boundary_comparison.hpp"
#include "measure_comparison.hpp"
#include "named_balls.hpp"
#include "nerve.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::RandomSource;

TEST(Slow, BoundariesOfDegenerateSets) {
  RandomSource random(71);
  for (int k = 0; k < oracle::rounds(500, 40000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(3, 14)));
    ASSERT_EQ(complaint_about_smallest(balls, boundary_differs(1, static_cast<uint64_t>(k))), "");
  }
}

TEST(Slow, BoundariesOfAnySets) {
  RandomSource random(72);
  for (int k = 0; k < oracle::rounds(75, 6000); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(10, 40)));
    ASSERT_EQ(complaint_about_smallest(balls, boundary_differs(1, static_cast<uint64_t>(k))), "");
  }
}

TEST(Slow, BoundariesWithNestedLoops) {
  RandomSource random(73);
  for (int k = 0; k < oracle::rounds(75, 6000); ++k) {
    const Balls balls = oracle::belted_balls(random, static_cast<size_t>(random.in(12, 45)));
    ASSERT_EQ(complaint_about_smallest(balls, boundary_differs(1, static_cast<uint64_t>(k))), "");
  }
}

TEST(Slow, BoundariesWithNestedLoopsAndTies) {
  RandomSource random(76);
  for (int k = 0; k < oracle::rounds(50, 3000); ++k) {
    const Balls balls = oracle::crowned_balls(random, static_cast<size_t>(random.in(12, 45)));
    ASSERT_EQ(complaint_about_smallest(balls, boundary_differs(1, static_cast<uint64_t>(k))), "");
  }
}

TEST(Slow, TopologyOfTheNerve) {
  RandomSource random(74);
  for (int k = 0; k < oracle::rounds(1000, 60000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(4, 11)));
    const std::array<int64_t, 3> betti = oracle::nerve_betti_numbers(balls);
    const hsp_boundary_counts counts = LibraryBoundary(balls).counts();
    ASSERT_EQ(counts.components, betti[0]) << oracle::to_text(balls);
    ASSERT_EQ(counts.voids, betti[2]) << oracle::to_text(balls);
    ASSERT_EQ(counts.euler, 2 * (betti[0] - betti[1] + betti[2])) << oracle::to_text(balls);
  }
}

TEST(Slow, MeasuresOfDegenerateSets) {
  RandomSource random(75);
  for (int k = 0; k < oracle::rounds(50, 3000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(2, 12)));
    ASSERT_EQ(complaint_about_smallest(balls, measures_differ), "");
  }
}

TEST(Slow, MeasuresOfNamedSets) {
  for (const oracle::KnownBalls &set : oracle::known_balls())
    EXPECT_EQ(complaint_about_smallest(set.balls, measures_differ), "") << set.name;
}

}  // namespace
