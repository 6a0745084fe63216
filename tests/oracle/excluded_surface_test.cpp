// The solvent-excluded surface by its definition (excluded_surface.hpp) against closed forms of one and two balls.
#include "excluded_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

constexpr double pi = std::numbers::pi;

TEST(ExcludedSurface, DistancesFromOutside) {
  const oracle::DistanceFromOutside one({{{0, 0, 0}, 5}});
  EXPECT_NEAR(one({1, 0, 0}).distance, 4, 1e-12);
  EXPECT_EQ(one({6, 0, 0}).distance, 0);
  // In the middle of two balls the nearest points are on their circle, of radius 3.
  const oracle::DistanceFromOutside two({{{-4, 0, 0}, 5}, {{4, 0, 0}, 5}});
  EXPECT_NEAR(two({0, 1, 0}).distance, 2, 1e-12);
  EXPECT_NEAR(two({-4, 0, 0.5}).distance, 4.5, 1e-12);
  // On the axis, and next to it as roundings leave points.
  EXPECT_NEAR(two({1, 0, 0}).distance, std::sqrt(10.0), 1e-12);
  const oracle::DistanceFromOutside slanted({{{0, 0, 0}, 5}, {{4.8, 3.84, 5.12}, 5}});
  EXPECT_NEAR(slanted({2.4, 1.92, 2.56}).distance, 3, 1e-9);
  const oracle::DistanceFromOutside uneven({{{1, 2, 2}, 3}, {{3, 6, 6}, 4}});
  EXPECT_NEAR(uneven({1.5, 3, 3}).distance, 2, 1e-9);
}

// Two balls of radius 4 at distance 8 and a probe of 1 have a saddle with the waist 3 - 1.
TEST(ExcludedSurface, BallAndSaddle) {
  const oracle::AreaAndVolume ball = oracle::excluded_surface_by_lines({{{0.1, 0.2, 0.3}, 5}}, 2, 60);
  EXPECT_NEAR(ball.area, 36 * pi, 36 * pi * 3e-3);
  EXPECT_NEAR(ball.volume, 36 * pi, 36 * pi * 3e-3);
  const oracle::AreaAndVolume two = oracle::excluded_surface_by_lines({{{-4, 0, 0}, 5}, {{4, 0, 0}, 5}}, 1, 80);
  const double t = std::atan2(4, 3);
  const double saddle = 2 * pi * (3 * 2 * t - 2 * 0.8);
  const double caps = 2 * (2 * pi * 4 * (4 + 3.2));
  EXPECT_NEAR(two.area, saddle + caps, (saddle + caps) * 3e-3);
  // The saddle's meridian 3 - sqrt(1 - x^2) runs from x = -.8 to .8, and takes a cap of height .8 off each ball.
  const double within = pi * (9 * 1.6 - 6 * (t + 0.48) + 1.6 - 2 * 0.512 / 3);
  const double balls = 2 * (4 * pi / 3 * 64 - pi * 0.64 * (12 - 0.8) / 3);
  EXPECT_NEAR(two.volume, within + balls, (within + balls) * 3e-3);
}

}  // namespace
