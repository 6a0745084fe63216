// One lattice step decides: every set of the corpus with one ball moved by one step or one radius changed by one step,
// on a coarse lattice and on one where the step is a 2^-29th of a radius. Slow oracles are asked of every third of
// them, which reaches all four numbers of a ball, up and down; of all in the long form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "computed_balls.hpp"
#include "corpus_expectations.hpp"
#include "long_reals.hpp"

namespace {

using degenerate::Scale;

TEST(OneStepOff, TopologyOfTheNerve) {
  degenerate::expect_one_step_off(1, 9, Scale::as_given, degenerate::nerve_disagrees, 3);
}
TEST(OneStepOff, BoundaryOfBruteForce) {
  degenerate::expect_one_step_off(1, 7, Scale::as_given, degenerate::brute_force_disagrees, 3);
}
TEST(OneStepOff, BoundaryOfBruteForceOnTheFinestLattice) {
  degenerate::expect_one_step_off(1, 6, Scale::half_of_lattice, degenerate::brute_force_disagrees, 3);
}
TEST(OneStepOff, KeepsTheInvariants) {
  degenerate::expect_one_step_off(1, 14, Scale::as_given, boundary_invariant_broken);
  degenerate::expect_one_step_off(1, 14, Scale::half_of_lattice, boundary_invariant_broken);
}
TEST(OneStepOff, Order) {
  degenerate::expect_one_step_off(1, 10, Scale::as_given, degenerate::orders_disagree);
  degenerate::expect_one_step_off(1, 10, Scale::half_of_lattice, degenerate::orders_disagree);
}
TEST(OneStepOff, Axes) {
  degenerate::expect_one_step_off(1, 10, Scale::as_given, degenerate::axes_disagree);
  degenerate::expect_one_step_off(1, 10, Scale::half_of_lattice, degenerate::axes_disagree);
}
TEST(OneStepOff, AreasAndVolumesOfSlices) {
  if (!oracle::has_long_reals) GTEST_SKIP() << "long doubles are doubles here";
  degenerate::expect_one_step_off(1, 4, Scale::as_given, degenerate::slices_disagree, 3);
  degenerate::expect_one_step_off(1, 3, Scale::half_of_lattice, degenerate::slices_disagree, 3);
}

// Half of each sphere and a strip half a step high: 2 pi r (r + 1/2), wherever the balls are.
TEST(OneStepOff, EqualBallsOneStepApart) {
  for (const int64_t radius : {10, 1000003, 1073741823}) {
    const auto r = static_cast<double>(radius);
    for (const oracle::Balls &balls :
         {oracle::Balls{{0, 0, 0, radius}, {1, 0, 0, radius}}, oracle::Balls{{0, 0, 7, radius}, {0, 0, 6, radius}}}) {
      const LibraryBoundary::Measures measures = LibraryBoundary(balls).measure();
      const double strip = 2 * std::numbers::pi * r * (r + 0.5);
      EXPECT_NEAR(measures.area[0], strip, 4e-16 * strip);
      EXPECT_NEAR(measures.area[1], strip, 4e-16 * strip);
      // A ball, and between its halves what is nearly a disc.
      const double volume = 4 * std::numbers::pi / 3 * r * r * r + std::numbers::pi * (r * r - 1.0 / 12);
      EXPECT_NEAR(measures.totals.volume, volume, 1e-15 * volume);
    }
  }
}

}  // namespace
