// The library's own elementary functions against a longer floating-point format.
#include "core/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "random_balls.hpp"

namespace {

// Error in units in the last place of the result. The reference needs 11 more bits than a double.
double error_in_ulp(double y, double x) {
  const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  const double rounded = std::fabs(static_cast<double>(exact));
  const double ulp = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  return static_cast<double>(std::fabs(static_cast<long double>(hsp::arc_tangent(y, x)) - exact) / ulp);
}

TEST(ArcTangent, StaysWithinItsBound) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is no longer than double here";
  oracle::RandomSource random(7);
  const auto number = [&random](int widest) {
    const double mantissa = random.fraction();
    const int exponent = static_cast<int>(random.in(-widest, widest));
    return (random.one_in(2) ? 1.0 : -1.0) * std::ldexp(0.5 + mantissa / 2, exponent);
  };
  double worst = 0.0;
  for (int k = 0; k < 2000000; ++k) {
    const int widest = k % 3 == 0 ? 1 : k % 3 == 1 ? 6 : 300;
    const double y = number(widest);
    const double x = number(widest);
    worst = std::max(worst, error_in_ulp(y, x));
  }
  // Around multiples of 1/64, at one of which the reduction changes.
  for (int k = 1; k <= 64; ++k) {
    double y = k / 64.0;
    for (int step = 0; step < 64; ++step) y = std::nextafter(y, 0.0);
    for (int step = 0; step < 128; ++step, y = std::nextafter(y, 2.0)) {
      for (const double x : {1.0, -1.0, 3.0}) worst = std::max(worst, error_in_ulp(y * x, x));
    }
  }
  EXPECT_LT(worst, hsp::arc_tangent_max_ulp);
  EXPECT_GT(worst, 0.5);
  RecordProperty("units in the last place", std::to_string(worst));
}

TEST(ArcTangent, AxesAndExtremes) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(hsp::arc_tangent(0.0, 1.0), 0.0);
  EXPECT_EQ(hsp::arc_tangent(0.0, 0.0), 0.0);
  EXPECT_EQ(hsp::arc_tangent(0.0, -1.0), hsp::pi);
  EXPECT_EQ(hsp::arc_tangent(1.0, 0.0), hsp::pi / 2);
  EXPECT_EQ(hsp::arc_tangent(-1.0, 0.0), -hsp::pi / 2);
  EXPECT_EQ(hsp::arc_tangent(1.0, 1.0), hsp::pi / 4);
  EXPECT_EQ(hsp::arc_tangent(huge, huge), hsp::pi / 4);
  EXPECT_EQ(hsp::arc_tangent(-huge, -huge), -3 * hsp::pi / 4);
  EXPECT_EQ(hsp::arc_tangent(tiny, tiny), hsp::pi / 4);
  EXPECT_EQ(hsp::arc_tangent(tiny, huge), 0.0);
  EXPECT_EQ(hsp::arc_tangent(huge, tiny), hsp::pi / 2);
  EXPECT_EQ(hsp::arc_tangent(-tiny, -huge), -hsp::pi);
  EXPECT_EQ(hsp::arc_tangent(-0.0, -1.0), hsp::pi);
  EXPECT_EQ(hsp::arc_tangent(3 * tiny, 4 * tiny), hsp::arc_tangent(3.0, 4.0));
  EXPECT_EQ(hsp::arc_tangent(huge / 2, huge), hsp::arc_tangent(1.0, 2.0));
}

TEST(DirectionOf, StaysWithinItsBound) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is no longer than double here";
  oracle::RandomSource random(11);
  long double worst = 0.0L;
  const auto measure = [&worst](double angle) {
    const hsp::SinCos at = hsp::sin_cos(angle);
    worst = std::max(worst, std::fabs(at.cosine - std::cos(static_cast<long double>(angle))));
    worst = std::max(worst, std::fabs(at.sine - std::sin(static_cast<long double>(angle))));
  };
  for (int k = 0; k < 2000000; ++k) {
    const double unit = 2 * random.fraction() - 1;
    measure(unit * (k % 3 == 0 ? 1.0 : k % 3 == 1 ? 8.0 : hsp::largest_angle));
  }
  for (int quarter = -40; quarter <= 40; ++quarter) measure(quarter * (hsp::pi / 4));
  EXPECT_LT(worst, hsp::sin_cos_max_error * 0x1p-53L);
  EXPECT_GT(worst, 0x1p-54L);
}

TEST(DirectionOf, NoAngle) {
  EXPECT_EQ(hsp::sin_cos(0.0).cosine, 1.0);
  EXPECT_EQ(hsp::sin_cos(0.0).sine, 0.0);
}

TEST(FloatingPoint, FiniteIsWhatItSays) {
  EXPECT_TRUE(hsp::is_finite(0.0));
  EXPECT_TRUE(hsp::is_finite(std::numeric_limits<double>::max()));
  EXPECT_FALSE(hsp::is_finite(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(hsp::is_finite(-std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(hsp::is_finite(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
