// The hard-sphere figures of Section 2 against looking at every pair.
#include <gtest/gtest.h>

#include <cmath>

#include "brute_queries.hpp"
#include "library_run.hpp"
#include "named_balls.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"

namespace {

using oracle::Balls;
using oracle::RandomSource;

void expect_close(double value, long double expected, const char *name, const Balls &balls) {
  EXPECT_LE(std::abs(static_cast<long double>(value) - expected), 4e-15L * std::abs(expected))
      << name << " " << value << " for " << static_cast<double>(expected) << " of " << oracle::to_text(balls);
}

void expect_figures(const Balls &balls) {
  const LibraryModel model(balls);
  hsp_packing figures;
  ASSERT_EQ(hsp_model_get_packing(model.handle(), &figures), HSP_OK);
  const oracle::Figures expected = oracle::brute_figures(balls);
  expect_close(figures.k, expected.k, "k", balls);
  expect_close(figures.rho, expected.rho, "rho", balls);
  expect_close(figures.mean_overlaps, expected.mean_overlaps, "mean overlaps", balls);
  expect_close(figures.neighbour_bound, expected.neighbour_bound, "neighbour bound", balls);
  EXPECT_EQ(figures.max_overlaps, expected.max_overlaps) << oracle::to_text(balls);
  EXPECT_EQ((figures.flags & HSP_PACKING_ZERO_RADIUS) != 0, expected.zero_radius) << oracle::to_text(balls);
  EXPECT_EQ((figures.flags & HSP_PACKING_COINCIDENT) != 0, expected.coincident) << oracle::to_text(balls);
  EXPECT_EQ((figures.flags & HSP_PACKING_NO_PAIR) != 0, expected.no_pair) << oracle::to_text(balls);
  if (figures.flags == 0) {
    // Theorem 2.1: no ball meets more others than the bound says.
    EXPECT_GE(figures.neighbour_bound, figures.max_overlaps);
  }
}

TEST(Figures, OfHardlyAnyBalls) {
  expect_figures({});
  expect_figures({{1, 2, 3, 4}});
  expect_figures({{1, 2, 3, 0}});
  expect_figures({{0, 0, 0, 5}, {10, 0, 0, 5}});  // touching is no overlap here
  expect_figures({{0, 0, 0, 5}, {9, 0, 0, 5}});
  expect_figures({{0, 0, 0, 5}, {0, 0, 0, 3}});
  expect_figures({{0, 0, 0, 0}, {7, 0, 0, 3}});
  expect_figures({{0, 0, 0, 0}, {7, 0, 0, 0}});
  expect_figures({{7, 0, 0, 0}, {7, 0, 0, 0}});
  expect_figures({{7, 0, 0, 0}, {7, 0, 0, 0}, {9, 0, 0, 1}});
}

TEST(Figures, OfNamedSets) {
  for (const oracle::KnownBalls &set : oracle::known_balls()) expect_figures(set.balls);
}

TEST(Figures, OfRandomSets) {
  RandomSource random(41);
  for (int k = 0; k < 1000; ++k) {
    expect_figures(oracle::any_balls(random, static_cast<size_t>(random.in(1, 30))));
    if (k % 20 == 0) expect_figures(oracle::loose_balls(random, 300));
  }
}

TEST(Figures, OfSparseSetsWhoseClosestPairIsManyCubesApart) {
  RandomSource random(42);
  for (int k = 0; k < 300; ++k) {
    const int64_t reach = int64_t{1} << random.in(4, 48);
    const auto n = static_cast<size_t>(random.in(2, 40));
    expect_figures(oracle::balls_in_box(random, n, reach, 1, 3));
  }
}

TEST(Figures, OfCollidingCubes) {
  RandomSource random(44);
  for (int k = 0; k < 40; ++k) expect_figures(oracle::colliding_balls(random, static_cast<size_t>(random.in(2, 500))));
}

TEST(Figures, WhereTheSmallestRatioIsNotTheSmallestDistance) {
  // rho divides by the larger radius: the pair that attains it may be the farther one.
  expect_figures({{0, 0, 0, 1}, {3, 0, 0, 1}, {1000, 0, 0, 100}, {1000, 120, 0, 50}});
  expect_figures({{0, 0, 0, 100}, {0, 0, 150, 2}, {0, 300, 0, 1}, {0, 302, 0, 1}});
  RandomSource random(43);
  for (int k = 0; k < 300; ++k) {
    const Balls balls = oracle::joined({{0, 0, 0, 2000}}, oracle::balls_in_box(random, 29, 9000, 1, 30));
    expect_figures(oracle::permuted(balls, random.permutation(balls.size())));
  }
}

}  // namespace
