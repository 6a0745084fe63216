// Gradients of areas, volume and energies against difference quotients of the library's own areas and volumes and of
// those of slices.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "gradient_comparison.hpp"
#include "gradient_sets.hpp"
#include "long_reals.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;

// Some of the balls, by a fixed choice.
std::vector<size_t> some_of(const Balls &balls, size_t n, oracle::RandomSource &random) {
  std::vector<size_t> chosen;
  for (const uint32_t ball : random.permutation(balls.size()))
    if (chosen.size() < n) chosen.push_back(ball);
  return chosen;
}

void expect_nearly_all_known(const GradientTally &tally) {
  std::cout << to_text(tally) << "\n";
  EXPECT_TRUE(nearly_all_known(tally)) << to_text(tally);
}

TEST(Gradients, OfSetsOfEveryKind) {
  oracle::RandomSource random(81);
  GradientTally tally;
  for (const oracle::NamedBalls &set : sets_of_every_kind(82))
    EXPECT_EQ(gradients_differ(set.balls, some_of(set.balls, 5, random), measured_by_library, tally), "") << set.name;
  expect_nearly_all_known(tally);
}

TEST(Gradients, OfMolecules) {
  const size_t chosen = oracle::emulated ? 1 : 6;
  oracle::RandomSource random(83);
  GradientTally tally;
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests())
    EXPECT_EQ(gradients_differ(set.balls, some_of(set.balls, chosen, random), measured_by_library, tally), "")
        << set.name;
  expect_nearly_all_known(tally);
}

// The comparison with slices rests on this: turned, they say the same.
TEST(Gradients, SlicesAreAsExactAsAssumed) {
  if (!oracle::has_long_reals) GTEST_SKIP() << "long doubles are doubles here";
  for (const oracle::NamedBalls &set : sets_of_every_kind(85)) {
    if (set.balls.size() > 20) continue;
    Balls turned;
    for (const oracle::LatticeBall &ball : set.balls) turned.push_back({ball.z, ball.x, ball.y, ball.radius});
    const MeasuredValues here = measured_by_slices(set.balls);
    const MeasuredValues there = measured_by_slices(turned);
    for (size_t i = 0; i < set.balls.size(); ++i)
      EXPECT_LE(std::abs(here.area[i].value - there.area[i].value), here.area[i].noise) << set.name << ", ball " << i;
    EXPECT_LE(std::abs(here.volume[0].value - there.volume[0].value), here.volume[0].noise) << set.name;
  }
}

TEST(Gradients, OfSlices) {
  oracle::RandomSource random(84);
  GradientTally tally;
  for (const oracle::NamedBalls &set : sets_of_every_kind(85)) {
    if (set.balls.size() > 20) continue;
    EXPECT_EQ(gradients_differ(set.balls, some_of(set.balls, 1, random), measured_by_slices, tally), "") << set.name;
  }
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests()) {
    const Balls piece = nearest_to_first(set.balls, 9);
    EXPECT_EQ(gradients_differ(piece, some_of(piece, 1, random), measured_by_slices, tally), "") << set.name;
  }
  expect_nearly_all_known(tally);
}

}  // namespace
