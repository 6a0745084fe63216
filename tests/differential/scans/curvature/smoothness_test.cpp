// How smooth volume V, weighted area S and its mean W over a window of radii are where their derivatives break: where
// spheres begin to touch from outside or inside, where an arc is born, where a fourth sphere comes through a vertex.
//
// A scan past such a place, with points h apart, has a largest change of a derivative between neighbours. As h becomes
// a sixteenth, that falls as h^e: with e = 1 the derivative is steady, with 1/2 it has the slope of a root, with 0 it
// jumps, and with -1/2 it has no bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "library_run.hpp"
#include "moved_ball.hpp"

namespace {

struct Exponents {
  double slope, bend;
};

// Around the place `middle`, which lies between two points.
Exponents exponents(const MovedBall &moved, Quantity quantity, double middle, double reach) {
  std::array<SlopeAndBend, 2> largest{};
  std::array<int, 2> points = {512, 8192};
  for (size_t level = 0; level < 2; ++level) {
    SlopeAndBend before{};
    for (int k = 0; k < points[level]; ++k) {
      const SlopeAndBend at = derivatives(moved, quantity, middle + reach * ((2 * k + 1.0) / points[level] - 1));
      if (k > 0) {
        largest[level].slope = std::max(largest[level].slope, std::fabs(at.slope - before.slope));
        largest[level].bend = std::max(largest[level].bend, std::fabs(at.bend - before.bend));
      }
      before = at;
    }
  }
  const auto exponent = [](double coarse, double fine) { return std::log(coarse / fine) / std::log(16.0); };
  return {exponent(largest[0].slope, largest[1].slope), exponent(largest[0].bend, largest[1].bend)};
}

// The place between two t where the boundary of the set, grown, gets other vertices or circles.
double event_between(const MovedBall &moved, double grown, double from, double to) {
  const auto kind = [&](double t) {
    const hsp_boundary_counts counts = LibraryBoundary(moved.at(t, grown)).counts();
    return std::array<uint32_t, 2>{counts.vertices, counts.circles};
  };
  const auto first = kind(from);
  EXPECT_NE(first, kind(to)) << "nothing happens between " << from << " and " << to;
  for (int k = 0; k < 40; ++k) {
    const double middle = (from + to) / 2;
    (kind(middle) == first ? from : to) = middle;
  }
  return to;
}

struct Expected {
  Exponents volume, area, mean;
};

// The place is t = 0; of the mean there are two, one for either volume, within `shifted`.
void check(const MovedBall &moved, double reach, double shifted, const Expected &expected) {
  const auto expect = [](const Exponents &found, const Exponents &wanted, const char *name) {
    EXPECT_NEAR(found.slope, wanted.slope, 0.06) << name << ", slope";
    EXPECT_NEAR(found.bend, wanted.bend, 0.06) << name << ", bend";
  };
  expect(exponents(moved, Quantity::volume, 0, reach), expected.volume, "V");
  expect(exponents(moved, Quantity::area, 0, reach), expected.area, "S");
  for (const double grown : {moved.window, -moved.window})
    expect(exponents(moved, Quantity::mean, event_between(moved, grown, -shifted, shifted), reach), expected.mean, "W");
}

TEST(Smoothness, WhereSpheresTouchFromOutside) {
  const MovedBall moved{{ball_of(0, 0, 0, 1.5), ball_of(2.7, 0, 0, 1.2)}, 1, {1, 0, 0}, {1, 0.5}, 0.1};
  check(moved, 0.05, 0.3, {{1, 0}, {0, 0}, {1, 0}});
}

TEST(Smoothness, WhereSpheresTouchFromInside) {
  const MovedBall moved{{ball_of(0, 0, 0, 1.5), ball_of(0.3, 0, 0, 1.2)}, 1, {1, 0, 0}, {1, 0.5}, 0.1};
  check(moved, 0.02, 0.1, {{1, 0}, {0, 0}, {1, 0}});
}

// The third sphere reaches the circle of the first two in the plane of the centres.
TEST(Smoothness, WhereAnArcIsBorn) {
  const double radius = std::sqrt(5.0);
  const MovedBall moved{
      {ball_of(-2, 0, 0, radius), ball_of(2, 0, 0, radius), ball_of(0, 2, 0, 1)}, 2, {0, 1, 0}, {1, 0.5, 0.8}, 0.02};
  check(moved, 0.02, 0.1, {{1, 0.5}, {0.5, -0.5}, {1, 0.5}});
}

// Four spheres through one point, which the last one leaves.
TEST(Smoothness, WhereAFourthSphereComesThroughAVertex) {
  const double radius = std::sqrt(3.0);
  const MovedBall moved{
      {ball_of(1, 1, 1, radius), ball_of(1, -1, -1, radius), ball_of(-1, 1, -1, radius), ball_of(-1, -1, 1, radius)},
      3,
      {-0.6, -0.5, 0.3},
      {1, 0.5, 0.8, 0.7},
      0.02};
  check(moved, 0.02, 0.1, {{1, 1}, {1, 0}, {1, 1}});
}

}  // namespace
