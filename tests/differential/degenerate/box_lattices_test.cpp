// Large lattices by a rule for their sizes. The part of the union that is nearest to one ball is its part in a
// box; the indicator of a box that is bounded on both sides of an axis is that of the whole axis less those of the two
// sides. So area and volume are affine in each of the three counts, and eight lattices of at most eight balls, measured
// by slices, tell those of all others.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "box_lattice.hpp"
#include "set_checks.hpp"
#include "slice_quadrature.hpp"

namespace {

using degenerate::BoxLattice;

oracle::SliceMeasures extrapolated(const BoxLattice &lattice) {
  oracle::SliceMeasures sum;
  for (unsigned corner = 0; corner < 8; ++corner) {
    BoxLattice small = lattice;
    long double weight = 1;
    for (size_t k = 0; k < 3; ++k) {
      small.counts[k] = (corner >> k & 1U) != 0 ? 2 : 1;
      weight *= static_cast<long double>((corner >> k & 1U) != 0 ? lattice.counts[k] - 1 : 2 - lattice.counts[k]);
    }
    const oracle::SliceMeasures measures = oracle::measure_by_slices(oracle::real_balls(degenerate::balls_of(small)));
    sum.area += weight * measures.area;
    sum.volume += weight * measures.volume;
  }
  return sum;
}

// Balls that reflections of the lattice exchange have equal areas.
void expect_symmetry(const BoxLattice &lattice, const std::vector<double> &area) {
  std::map<std::array<int64_t, 3>, double> of_class;
  size_t ball = 0;
  const double sphere = 4 * std::numbers::pi * static_cast<double>(lattice.radius * lattice.radius);
  for (int64_t i = 0; i < lattice.counts[0]; ++i)
    for (int64_t j = 0; j < lattice.counts[1]; ++j)
      for (int64_t k = 0; k < lattice.counts[2]; ++k, ++ball) {
        const std::array<int64_t, 3> place = {std::min(i, lattice.counts[0] - 1 - i),
                                              std::min(j, lattice.counts[1] - 1 - j),
                                              std::min(k, lattice.counts[2] - 1 - k)};
        const auto [found, is_new] = of_class.try_emplace(place, area[ball]);
        EXPECT_NEAR(found->second, area[ball], 1e-13 * sphere) << degenerate::name_of(lattice) << ", ball " << ball;
      }
}

void expect_law(const BoxLattice &lattice) {
  const LibraryBoundary boundary(degenerate::balls_of(lattice));
  EXPECT_EQ(degenerate::to_text(degenerate::topology_of(boundary)),
            degenerate::to_text(degenerate::topology_of(lattice)))
      << degenerate::name_of(lattice);
  const oracle::SliceMeasures expected = extrapolated(lattice);
  const LibraryBoundary::Measures measures = boundary.measure();
  EXPECT_LE(std::abs(static_cast<long double>(measures.totals.area) - expected.area), 1e-12L * expected.area)
      << degenerate::name_of(lattice);
  EXPECT_LE(std::abs(static_cast<long double>(measures.totals.volume) - expected.volume), 1e-12L * expected.volume)
      << degenerate::name_of(lattice);
  expect_symmetry(lattice, measures.area);
}

TEST(BoxLattices, CubicOfManyRadii) {
  for (const int64_t radius : {40, 50, 51, 60, 70, 71, 80, 86, 87, 100, 120, 140, 141, 142, 150, 170, 180})
    expect_law({{6, 5, 7}, {100, 100, 100}, radius});
}

TEST(BoxLattices, OfBoxesThatCloseExactly) {
  for (const int64_t radius : {1, 2, 3, 4, 5}) expect_law({{7, 6, 5}, {2, 4, 4}, radius});
  for (const int64_t radius : {2, 3, 5, 6, 7, 8}) expect_law({{5, 6, 7}, {4, 6, 12}, radius});
  for (const int64_t radius : {3, 4, 5, 12, 13, 14}) expect_law({{6, 6, 4}, {6, 8, 24}, radius});
}

TEST(BoxLattices, OfThousandsOfBalls) {
  for (const int64_t radius : {5, 6, 8, 9, 10}) expect_law({{13, 12, 11}, {10, 10, 10}, radius});
  for (const int64_t radius : {2, 3}) expect_law({{12, 12, 12}, {2, 4, 4}, radius});
}

TEST(BoxLattices, InAPlaneAndOnALine) {
  for (const int64_t radius : {3, 4, 5, 6, 9}) {
    expect_law({{20, 30, 1}, {6, 8, 1}, radius});
    expect_law({{1, 1, 500}, {1, 1, 8}, radius});
  }
}

}  // namespace
