// Bond scans: the area of two balls as their distance passes through containment, touching from inside, overlap and
// touching from outside. It must not jump anywhere, and its gradient must be the gradient of just this area.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hardsphere.h"
#include "long_reals.hpp"
#include "pair_formulas.hpp"
#include "pair_scan.hpp"

namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr int64_t thousandth = units_per_angstrom / 1000;

Real real(int64_t length) {
  return static_cast<Real>(length);
}

PairFormulas formulas_of(const PairOfBalls &pair) {
  return {real(pair.radius[0]), real(pair.radius[1])};
}

// Of a sphere of the larger radius: what rounding errors are relative to.
Real area_scale(const PairOfBalls &pair) {
  const Real r = real(std::max(pair.radius[0], pair.radius[1]));
  return 4 * pi * r * r;
}

// Every thousandth of an angstrom from 0 to beyond touching, and around both kinds of touching every exact distance.
std::vector<int64_t> scan_of(const PairOfBalls &pair) {
  std::vector<int64_t> distances;
  for (int64_t d = 0; d <= pair.touching() + 300 * thousandth; d += thousandth) distances.push_back(d);
  for (const int64_t d : {pair.touching_from_inside(), pair.touching()})
    for (int64_t k = -100; k <= 100; ++k)
      if (d + k * shortest_change >= 0) distances.push_back(d + k * shortest_change);
  std::sort(distances.begin(), distances.end());
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  return distances;
}

class BondScan : public testing::TestWithParam<PairOfBalls> {};

TEST_P(BondScan, ValuesAreThoseOfClosedForms) {
  const PairOfBalls &pair = GetParam();
  const PairFormulas formulas = formulas_of(pair);
  const Real tolerance = 1e-15L * area_scale(pair);
  const Real radius = real(std::max(pair.radius[0], pair.radius[1]));
  for (const int64_t d : scan_of(pair)) {
    SCOPED_TRACE(d);
    const PairResults found = pair_at(pair, d, HSP_TANGENT_OVERLAP);
    std::array<Real, 2> areas = formulas.areas(real(d));
    // Equal balls: either of them may have the area.
    if (d == 0 && pair.radius[0] == pair.radius[1] && found.area[0] == 0) std::swap(areas[0], areas[1]);
    for (const size_t i : {0U, 1U}) ASSERT_LE(std::abs(static_cast<Real>(found.area[i]) - areas[i]), tolerance);
    ASSERT_LE(std::abs(static_cast<Real>(found.volume) - formulas.volume(real(d))), tolerance * radius);

    // Where one of the balls lies inside the other or touches it from there, nothing depends on the distance; where
    // they touch from outside, the derivatives are those of overlapping balls.
    const bool constant = d <= pair.touching_from_inside() || d > pair.touching();
    const std::array<Real, 2> slopes = constant ? std::array<Real, 2>{0, 0} : formulas.areas_by_distance(real(d));
    // Those of single areas are large of either sign where the balls nearly touch from inside.
    const Real size = 2e-15L * (std::abs(slopes[0]) + std::abs(slopes[1]) + 2 * pi * radius);
    for (const size_t i : {0U, 1U}) ASSERT_LE(std::abs(static_cast<Real>(found.area_by_distance[i]) - slopes[i]), size);
    ASSERT_LE(std::abs(static_cast<Real>(found.total_by_distance) - (slopes[0] + slopes[1])), size);
    const Real growth = constant ? 0 : formulas.volume_by_distance(real(d));
    ASSERT_LE(std::abs(static_cast<Real>(found.volume_by_distance) - growth), 1e-14L * radius * radius);
  }
}

// On the middle piece the derivatives are monotone in d: between two distances an area changes by no more than their
// difference times the larger slope at the two. On the others it does not change at all.
TEST_P(BondScan, AreasDoNotJump) {
  const PairOfBalls &pair = GetParam();
  const PairFormulas formulas = formulas_of(pair);
  const Real rounding = 1e-15L * area_scale(pair);
  const std::vector<int64_t> scan = scan_of(pair);
  PairResults last = pair_at(pair, scan[0], HSP_TANGENT_OVERLAP);
  for (size_t k = 1; k < scan.size(); ++k) {
    SCOPED_TRACE(scan[k]);
    const PairResults next = pair_at(pair, scan[k], HSP_TANGENT_OVERLAP);
    const Real width = real(scan[k] - scan[k - 1]);
    const bool constant = scan[k] <= pair.touching_from_inside() || scan[k - 1] >= pair.touching();
    Real total_slope = 0;
    for (const size_t i : {0U, 1U}) {
      Real slope = 0;
      if (!constant)
        for (const int64_t d : {scan[k - 1], scan[k]})
          if (d > 0) slope = std::max(slope, std::abs(formulas.areas_by_distance(real(d))[i]));
      total_slope += slope;
      // From two balls at one place on, which of them has the area changes; the total does not.
      if (scan[k - 1] > 0 || pair.touching_from_inside() > 0) {
        ASSERT_LE(std::abs(static_cast<Real>(next.area[i]) - static_cast<Real>(last.area[i])),
                  slope * width + rounding);
      }
    }
    const Real change = static_cast<Real>(next.area[0]) + static_cast<Real>(next.area[1]) -
                        static_cast<Real>(last.area[0]) - static_cast<Real>(last.area[1]);
    ASSERT_LE(std::abs(change), total_slope * width + 2 * rounding);
    last = next;
  }
}

// Simpson's rule over an even number of intervals, each of this width, from the distance `from` on. The tangency is
// that of overlapping balls, so that the end where they touch belongs to the piece.
struct Integrals {
  std::array<Real, 2> area{};
  Real total = 0;
  Real volume = 0;
};
Integrals integrate(const PairOfBalls &pair, int64_t from, int64_t width, int64_t intervals) {
  Integrals sums;
  for (int64_t k = 0; k <= intervals; ++k) {
    const PairResults at = pair_at(pair, from + k * width, HSP_TANGENT_OVERLAP);
    const Real weight = real(width) / 3 * (k == 0 || k == intervals ? 1 : k % 2 == 0 ? 2 : 4);
    for (const size_t i : {0U, 1U}) sums.area[i] += weight * static_cast<Real>(at.area_by_distance[i]);
    sums.total += weight * static_cast<Real>(at.total_by_distance);
    sums.volume += weight * static_cast<Real>(at.volume_by_distance);
  }
  return sums;
}

// The error of Simpson's rule is (b - a) w^4 / 180 times at most the fourth derivative of what is integrated.
TEST_P(BondScan, GradientsIntegrateBackToAreasAndVolume) {
  if (!oracle::has_long_reals) GTEST_SKIP() << "long doubles are doubles here";
  const PairOfBalls &pair = GetParam();
  const PairFormulas formulas = formulas_of(pair);
  const Real rounding = 4e-15L * area_scale(pair);
  // The total's derivative and the volume's are continuous where the small ball begins to poke out of the large one:
  // that end is included. Those of single areas jump there, and equal balls at one place have no direction: a little
  // way from them they are included.
  const int64_t inside = pair.touching_from_inside();
  for (const int64_t from : {inside, inside + 20 * thousandth, inside + 200 * thousandth}) {
    if (from == 0) continue;
    const int64_t intervals = (pair.touching() - from) / thousandth;
    ASSERT_EQ(intervals * thousandth, pair.touching() - from);
    ASSERT_EQ(intervals % 2, 0);
    const Integrals found = integrate(pair, from, thousandth, intervals);
    const PairResults start = pair_at(pair, from, HSP_TANGENT_OVERLAP);
    const PairResults end = pair_at(pair, pair.touching(), HSP_TANGENT_OVERLAP);
    const Real factor = real(pair.touching() - from) * std::pow(real(thousandth), 4) / 180;
    const Real total = static_cast<Real>(end.area[0]) + static_cast<Real>(end.area[1]) -
                       static_cast<Real>(start.area[0]) - static_cast<Real>(start.area[1]);
    EXPECT_LE(std::abs(found.total - total), factor * formulas.fifth_derivative_of_total(real(from)) + rounding)
        << from;
    const Real radius = real(std::max(pair.radius[0], pair.radius[1]));
    EXPECT_LE(std::abs(found.volume - (static_cast<Real>(end.volume) - static_cast<Real>(start.volume))),
              factor * formulas.fifth_derivative_of_volume(real(from)) + rounding * radius)
        << from;
    if (from == inside) continue;
    for (const size_t i : {0U, 1U})
      EXPECT_LE(std::abs(found.area[i] - (static_cast<Real>(end.area[i]) - static_cast<Real>(start.area[i]))),
                factor * formulas.fifth_derivatives_of_areas(real(from))[i] + rounding)
          << from;
  }
}

// Where the balls touch from outside, both one-sided derivatives are there, the right one on either side of it.
TEST_P(BondScan, TouchingBallsHaveBothOneSidedDerivatives) {
  const PairOfBalls &pair = GetParam();
  const int64_t touching = pair.touching();
  const Real slope = 4 * pi * real(pair.radius[0]) * real(pair.radius[1]) / real(touching);
  const PairResults meeting = pair_at(pair, touching, HSP_TANGENT_OVERLAP);
  const PairResults apart = pair_at(pair, touching, HSP_TANGENT_DISJOINT);
  EXPECT_LE(std::abs(static_cast<Real>(meeting.total_by_distance) - slope), 1e-14L * slope);
  EXPECT_EQ(apart.total_by_distance, 0);
  EXPECT_EQ(apart.area, meeting.area);
  EXPECT_LE(std::abs(meeting.volume_by_distance), 1e-15 * static_cast<double>(area_scale(pair)));
  EXPECT_LE(std::abs(apart.volume_by_distance), 1e-15 * static_cast<double>(area_scale(pair)));
  for (const size_t i : {0U, 1U}) {
    EXPECT_EQ(meeting.flags[i], HSP_GRADIENT_ONE_SIDED);
    EXPECT_EQ(apart.flags[i], HSP_GRADIENT_ONE_SIDED);
    EXPECT_EQ(apart.area_by_distance[i], 0);
  }
  // d^2 A / dd^2 is at most 2 pi s t^2 / d^3: nothing that one step could show.
  for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT}) {
    const PairResults closer = pair_at(pair, touching - shortest_change, tangency);
    const PairResults farther = pair_at(pair, touching + shortest_change, tangency);
    EXPECT_NEAR(closer.total_by_distance, static_cast<double>(slope), static_cast<double>(1e-7L * slope));
    EXPECT_EQ(farther.total_by_distance, 0);
    for (const size_t i : {0U, 1U}) {
      EXPECT_EQ(closer.flags[i], 0U);
      EXPECT_EQ(farther.flags[i], 0U);
    }
  }
}

// Where one ball touches the other from inside, single areas have one-sided derivatives and the balls are flagged. The
// total area's derivative is continuous: one step beyond it is pi s (1 - t^2 / (t + step)^2) < 2 pi s step / t.
TEST_P(BondScan, BallsThatTouchFromInsideAreFlagged) {
  const PairOfBalls &pair = GetParam();
  const int64_t inside = pair.touching_from_inside();
  for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT}) {
    for (int64_t k = -1; k <= 1; ++k) {
      if (inside + k * shortest_change < 0) continue;
      const PairResults at = pair_at(pair, inside + k * shortest_change, tangency);
      for (const size_t i : {0U, 1U}) EXPECT_EQ(at.flags[i], k == 0 ? HSP_GRADIENT_ONE_SIDED : 0U) << k;
      if (inside > 0) {
        EXPECT_LE(std::abs(static_cast<Real>(at.total_by_distance)),
                  2 * pi * real(pair.touching()) * real(shortest_change) / real(inside))
            << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bonds, BondScan, testing::ValuesIn(scanned_pairs()),
                         [](const testing::TestParamInfo<PairOfBalls> &pair) {
                           const std::string name = pair.param.name;
                           return std::string(name[2] == 'O' ? "OxygenOxygen" : "OxygenHydrogen") +
                                  (name.size() > 3 ? "Accessible" : "");
                         });

}  // namespace
