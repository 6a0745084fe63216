// Areas and volumes against slicing the balls, and the identities that hold bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "library_run.hpp"
#include "measure_comparison.hpp"
#include "named_balls.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::RandomSource;
using Measures = LibraryBoundary::Measures;

TEST(Measures, OfLooseSetsAreThoseOfSlices) {
  RandomSource random(61);
  for (int k = 0; k < oracle::sets(25); ++k) {
    const Balls balls = oracle::loose_balls(random, static_cast<size_t>(random.in(5, 25)));
    ASSERT_EQ(complaint_about_smallest(balls, measures_differ), "");
  }
}

TEST(Measures, OfDenseClusteredAndBeltedSetsAreThoseOfSlices) {
  RandomSource random(62);
  for (int k = 0; k < oracle::sets(20); ++k) {
    ASSERT_EQ(complaint_about_smallest(oracle::dense_balls(random, 12), measures_differ), "");
    ASSERT_EQ(complaint_about_smallest(oracle::clustered_balls(random, 15), measures_differ), "");
    ASSERT_EQ(complaint_about_smallest(oracle::belted_balls(random, 20), measures_differ), "");
  }
}

TEST(Measures, OfDegenerateSetsAreThoseOfSlices) {
  RandomSource random(63);
  for (int k = 0; k < oracle::sets(500); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(1, 10)));
    ASSERT_EQ(complaint_about_smallest(balls, measures_differ), "");
  }
}

TEST(Measures, OfCrownedSetsAreThoseOfSlices) {
  RandomSource random(68);
  for (int k = 0; k < oracle::sets(20); ++k)
    ASSERT_EQ(complaint_about_smallest(oracle::crowned_balls(random, 20), measures_differ), "");
}

// Models of three balls, exact copies, and nearly equal ones in the long form: each ball has more than 160 neighbours,
// most of which do not matter (sphere/exposed_caps).
TEST(Measures, OfCopiesAreThoseOfSlices) {
  RandomSource random(69);
  constexpr int64_t jitters[] = {0, 1, 40, 300};
  for (int k = 0; k < oracle::rounds(1, 4); ++k) {
    const int64_t jitter = jitters[k];
    Balls balls;
    for (int copy = 0; copy < 60; ++copy) {
      const auto off = [&]() { return random.in(-jitter, jitter); };
      for (const int64_t at : {0, 900, 1700}) {
        balls.push_back({at + off(), at / 3 + off(), (at * at) % 700 + off(), 1000 + at / 10});
      }
    }
    EXPECT_EQ(measures_differ(balls), "") << jitter;
  }
}

TEST(Measures, OfNamedSetsAreThoseOfSlices) {
  for (const oracle::KnownBalls &set : oracle::known_balls())
    if (set.balls.size() <= 32) {
      EXPECT_EQ(complaint_about_smallest(set.balls, measures_differ), "") << set.name;
    }
}

// Property 1 of hsp_boundary_measure.
TEST(Measures, OfEachBallDoNotDependOnTheOrderOfTheBallsToTheBit) {
  RandomSource random(64);
  for (int k = 0; k < oracle::sets(1500); ++k) {
    Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 30)));
    std::sort(balls.begin(), balls.end());
    // Equal balls differ by their index only: here the area may wander from one to the other.
    balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
    const Measures sorted = LibraryBoundary(balls).measure();
    const std::vector<uint32_t> order = random.permutation(balls.size());
    const Measures mixed = LibraryBoundary(oracle::permuted(balls, order)).measure();
    for (size_t i = 0; i < order.size(); ++i) {
      ASSERT_EQ(mixed.area[i], sorted.area[order[i]]) << oracle::to_text(balls);
      ASSERT_EQ(mixed.volume[i], sorted.volume[order[i]]) << oracle::to_text(balls);
    }
  }
}

TEST(Measures, DoNotDependOnThePlace) {
  RandomSource random(65);
  for (int k = 0; k < oracle::sets(300); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 25)));
    const int64_t far = int64_t{1} << random.in(0, 49);
    Balls moved;
    for (const LatticeBall &b : balls) moved.push_back({b.x - far, b.y + far / 3, b.z + far, b.radius});
    const Measures here = LibraryBoundary(balls).measure();
    const Measures there = LibraryBoundary(moved).measure();
    EXPECT_EQ(here.area, there.area) << oracle::to_text(balls);
    EXPECT_EQ(here.volume, there.volume) << oracle::to_text(balls);
    EXPECT_EQ(here.totals.area, there.totals.area);
    EXPECT_EQ(here.totals.volume, there.totals.volume);
  }
}

TEST(Measures, ScaleAsAreasAndVolumes) {
  RandomSource random(66);
  for (int k = 0; k < oracle::sets(300); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 25)));
    const int64_t factor = random.in(2, 1000000);
    Balls scaled;
    for (const LatticeBall &b : balls) scaled.push_back({b.x * factor, b.y * factor, b.z * factor, b.radius * factor});
    const double step = std::ldexp(1.0, static_cast<int>(random.in(-60, 60)));
    const Measures unit = LibraryBoundary(balls).measure();
    const Measures large = LibraryBoundary(scaled, step).measure();
    const double length = static_cast<double>(factor) * step;
    const double area = unit.totals.area * length * length;
    const double volume = unit.totals.volume * length * length * length;
    EXPECT_LE(std::abs(large.totals.area - area), 1e-13 * area) << oracle::to_text(balls);
    EXPECT_LE(std::abs(large.totals.volume - volume), 1e-13 * volume) << oracle::to_text(balls);
  }
}

TEST(Measures, AddUpToTheTotals) {
  RandomSource random(67);
  for (int k = 0; k < oracle::sets(500); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(1, 60)));
    const Measures measures = LibraryBoundary(balls).measure();
    long double area = 0;
    long double volume = 0;
    for (const double a : measures.area) {
      EXPECT_GE(a, 0) << oracle::to_text(balls);
      area += static_cast<long double>(a);
    }
    for (const double v : measures.volume) volume += static_cast<long double>(v);
    EXPECT_NEAR(measures.totals.area, static_cast<double>(area), 1e-15 * measures.totals.area);
    EXPECT_NEAR(measures.totals.volume, static_cast<double>(volume), 1e-14 * measures.totals.volume);
  }
}

}  // namespace
