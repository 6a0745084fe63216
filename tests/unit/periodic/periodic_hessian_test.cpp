// Second derivatives of a rod of two equal balls that meets itself across a face of the box: the block of the two has a
// part from each of them, and is in closed form.
#include "periodic/periodic_hessian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "built_periodic.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;

TEST(PeriodicHessian, OfARod) {
  support::BallList balls;
  balls.add(0.5, 1, 1, 1.25);
  balls.add(2.25, 1, 1, 1.25);
  const BuiltPeriodic built(balls, {4, 0, 0, 0, 9, 0, 0, 0, 9}, 0.0, 0.125);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  std::vector<uint32_t> first(3, 7);
  ASSERT_TRUE(hsp::find_hessian_row_starts_in_box({}, built.get(), first.data()));
  ASSERT_EQ(first, (std::vector<uint32_t>{0, 2, 4}));
  // Of circles halfway between centres d apart, lib/curvature/curvature/hessians.hpp.
  double along = 0, across = 0, of_area = 0;
  for (const double d : {1.75, 2.25}) {
    along += pi * d / 2;
    across -= pi * (1.25 * 1.25 - d * d / 4) / d;
    of_area -= 2 * pi * 1.25 / d;
  }
  for (const bool area : {false, true}) {
    hsp::EnergyTerms terms;
    terms.tension = area ? 1 : 0;
    terms.pressure = area ? 0 : 1;
    terms.weights = hsp::weights_in_box(built.get(), nullptr, hsp::TouchingBalls::meet);
    std::vector<uint32_t> ball(4, 9), flags(3, 9);
    std::vector<double> block(36, NAN);
    ASSERT_TRUE(
        hsp::find_hessian_rows_in_box({}, built.get(), terms, {first.data(), ball.data(), block.data(), flags.data()}));
    EXPECT_EQ(ball, (std::vector<uint32_t>{0, 1, 0, 1}));
    EXPECT_EQ(flags, (std::vector<uint32_t>{0, 0, 0}));
    for (size_t k = 0; k < 36; ++k) {
      const size_t entry = k / 9, p = k / 3 % 3, q = k % 3;
      const double expected = p != q ? 0 : p == 0 ? (area ? 0 : along) : area ? of_area : across;
      EXPECT_NEAR(block[k], entry == 1 || entry == 2 ? expected : -expected, 1e-13) << area << ' ' << k;
    }
  }
}

// A large ball with more circles than those that it meets: one ball between it and its image, one on its other side.
TEST(PeriodicHessian, OfALargeBallWithSmallOnes) {
  constexpr double side = 6.75, large = 3, small = 0.5;
  support::BallList balls;
  balls.add(0, 0, 0, large);
  balls.add(side / 2, 0, 0, small);
  balls.add(0, -3, 0, small);
  const BuiltPeriodic built(balls, {side, 0, 0, 0, side, 0, 0, 0, side}, 0.0, 0.125);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  std::vector<uint32_t> first(4, 7);
  ASSERT_TRUE(hsp::find_hessian_row_starts_in_box({}, built.get(), first.data()));
  ASSERT_EQ(first, (std::vector<uint32_t>{0, 3, 5, 7}));
  hsp::EnergyTerms terms;
  terms.pressure = 1;
  terms.weights = hsp::weights_in_box(built.get(), nullptr, hsp::TouchingBalls::meet);
  std::vector<uint32_t> ball(7, 9);
  std::vector<double> block(63, NAN);
  ASSERT_TRUE(
      hsp::find_hessian_rows_in_box({}, built.get(), terms, {first.data(), ball.data(), block.data(), nullptr}));
  EXPECT_EQ(ball, (std::vector<uint32_t>{0, 1, 2, 0, 1, 0, 2}));
  // dV/dd is the disk of the circle, which is `from_large` away from the large centre.
  for (const uint32_t other : {1U, 2U}) {
    const double d = other == 1 ? side / 2 : 3.0, circles = other == 1 ? 2.0 : 1.0;
    const double from_large = (d * d + large * large - small * small) / (2 * d);
    const double along = 2 * pi * from_large * (1 - from_large / d);
    const double across = -pi * (large * large - from_large * from_large) / d;
    for (uint32_t k = 0; k < 9; ++k) {
      const bool is_along = k / 3 == other - 1;
      const double expected = k / 3 != k % 3 ? 0 : circles * (is_along ? along : across);
      EXPECT_NEAR(block[9 * size_t{other} + k], expected, 1e-12) << other << ' ' << k;
    }
  }
}

}  // namespace
