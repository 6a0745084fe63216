#include "maps/trigonometric_roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "random_balls.hpp"

namespace {

using hsp::TrigonometricPolynomial;

double value(const TrigonometricPolynomial &f, double t) {
  return f.constant + f.cosine * std::cos(t) + f.sine * std::sin(t) + f.square * std::cos(t) * std::cos(t);
}

// Against changes of sign between many samples. Sets with a value near 0 between two of them are left out.
TEST(TrigonometricRoots, AreThoseThatSamplingFinds) {
  oracle::RandomSource random(6);
  int with[9] = {};
  for (int time = 0; time < 20000; ++time) {
    const auto any = [&] { return 2 * random.fraction() - 1; };
    const TrigonometricPolynomial f{0.7 * any(), any(), any(), 3 * any()};
    const double from = 4 * any();
    const double to = from + 2 * std::numbers::pi * random.fraction();
    constexpr int samples = 2000;
    std::vector<double> expected;
    bool certain = true;
    double before = value(f, from);
    for (int k = 1; k <= samples; ++k) {
      const double t = from + (to - from) * k / samples;
      const double here = value(f, t);
      if ((before > 0) != (here > 0)) expected.push_back(t);
      certain = certain && std::abs(here) > 1e-4 * (to - from);
      before = here;
    }
    certain = certain && std::abs(value(f, from)) > 1e-3;
    double root[hsp::most_trigonometric_roots];
    const uint32_t count = hsp::find_roots(f, from, to, root);
    for (uint32_t k = 0; k < count; ++k) {
      EXPECT_NEAR(value(f, root[k]), 0, 1e-10);
      EXPECT_GT(root[k], k == 0 ? from : root[k - 1]);
      EXPECT_LT(root[k], to);
    }
    if (!certain) continue;
    ASSERT_EQ(count, expected.size()) << time;
    for (uint32_t k = 0; k < count; ++k) ASSERT_NEAR(root[k], expected[k], 2 * (to - from) / samples);
    ++with[count];
  }
  for (int k = 0; k <= 4; ++k) EXPECT_GT(with[k], 20) << k << " roots";
}

TEST(TrigonometricRoots, CloseToEachOtherAreTwo) {
  for (const double gap : {1e-2, 1e-4, 1e-6}) {
    // cos t = cos(gap): at +-gap.
    double root[hsp::most_trigonometric_roots];
    ASSERT_EQ(hsp::find_roots({-std::cos(gap), 1, 0, 0}, -1, 1.3, root), 2U) << gap;
    EXPECT_NEAR(root[0], -gap, 1e-9);
    EXPECT_NEAR(root[1], gap, 1e-9);
  }
}

// An interval that ends next to another root: the value there is nearly 0, of either sign.
TEST(TrigonometricRoots, AreNotLostWhenTheIntervalEndsAtAnother) {
  for (const double at : {0.1, 0.7, 1.2}) {
    for (int ulps = -40; ulps <= 40; ++ulps) {
      const double end = at * (1 + ulps * 0x1p-52);
      double root[hsp::most_trigonometric_roots];
      for (const double sign : {-1.0, 1.0}) {
        const TrigonometricPolynomial f{sign * std::cos(at), -sign, 0, 0};  // roots at -at and at
        ASSERT_GE(hsp::find_roots(f, -1.4, end, root), 1U) << at << ' ' << ulps;
        EXPECT_NEAR(root[0], -at, 1e-9) << at << ' ' << ulps;
        const uint32_t count = hsp::find_roots(f, -end, 1.4, root);
        ASSERT_GE(count, 1U) << at << ' ' << ulps;
        EXPECT_NEAR(root[count - 1], at, 1e-9) << at << ' ' << ulps;
      }
    }
  }
}

// Along a crease seen edge-on the distance to a point has extrema at both ends, rounded to 0 or next to it, and may
// have one between: the derivative is sin t (A + K cos t), here at an angle of pi / 4 less, as face_pole.cpp asks.
TEST(TrigonometricRoots, AreNotLostBetweenTwoOthersAtBothEnds) {
  oracle::RandomSource random(8);
  constexpr double eighth = std::numbers::pi / 4, root_half = 0.5 * std::numbers::sqrt2;
  for (int time = 0; time < 20000; ++time) {
    const double K = 2 * random.fraction() - 1, A = 0.9 * K * (2 * random.fraction() - 1);
    if (std::abs(K) < 1e-3) continue;
    double root[hsp::most_trigonometric_roots];
    const uint32_t count =
        hsp::find_roots({0.5 * K, -root_half * A, -root_half * A, -K}, -eighth, std::numbers::pi - eighth, root);
    const double expected = std::acos(-A / K) - eighth;
    EXPECT_TRUE(std::any_of(root, root + count, [&](double t) { return std::abs(t - expected) < 1e-9; }))
        << "A " << A << ", K " << K;
  }
}

// More than half a turn is asked about in two parts, which must agree on the sign where they meet.
TEST(TrigonometricRoots, AreNotLostInTheMiddle) {
  oracle::RandomSource random(9);
  for (int time = 0; time < 20000; ++time) {
    const double at = 6 * random.fraction() - 3, half = std::numbers::pi * (0.55 + 0.4 * random.fraction());
    // sin(t - at), with roots at `at` and half a turn from it.
    double root[hsp::most_trigonometric_roots];
    ASSERT_EQ(hsp::find_roots({0, -std::sin(at), std::cos(at), 0}, at - half, at + half, root), 1U) << at;
    EXPECT_NEAR(root[0], at, 1e-9);
  }
}

TEST(TrigonometricRoots, AreNoneWhereItTouches) {
  double root[hsp::most_trigonometric_roots];
  EXPECT_EQ(hsp::find_roots({1 + 0x1p-45, -1, 0, 0}, -1, 1.3, root), 0U);
  EXPECT_EQ(hsp::find_roots({1, 0.5, 0, 0}, -3, 3, root), 0U);
  EXPECT_EQ(hsp::find_roots({-0.5, 1, 0, 0}, 1, 1, root), 0U);
  EXPECT_EQ(hsp::find_roots({-0.5, 1, 0, 0}, 2, 1, root), 0U);
}

}  // namespace
