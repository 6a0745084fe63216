// Areas, vector areas and volumes by slices against closed forms, and against other steps and directions of slicing.
#include "slice_quadrature.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "random_balls.hpp"

namespace {

using namespace oracle;

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

void expect_near(Real value, Real expected, Real relative) {
  EXPECT_LE(std::abs(value - expected), relative * std::abs(expected)) << value << " for " << expected;
}

TEST(SliceQuadrature, OneBall) {
  const SliceMeasures measures = measure_by_slices({{1, 2, 3, 5}});
  expect_near(measures.area, 100 * pi, 1e-16L);
  expect_near(measures.volume, 500 * pi / 3, 1e-16L);
}

TEST(SliceQuadrature, TwoOverlappingBallsInAnyDirection) {
  // Distance 7, radii 5 and 4: the circle's plane is h from the first centre; caps of height 5 - h and 4 - (7 - h).
  const Real h = (49.0L + 25 - 16) / 14;
  const Real first_cap = 5 - h;
  const Real second_cap = 4 - (7 - h);
  const Real first_area = 100 * pi - 10 * pi * first_cap;
  const Real second_area = 64 * pi - 8 * pi * second_cap;
  const auto cap_volume = [](Real radius, Real height) { return pi * height * height * (3 * radius - height) / 3; };
  const Real volume = 4 * pi / 3 * (125 + 64) - cap_volume(5, first_cap) - cap_volume(4, second_cap);
  for (const RealBall &second : {RealBall{7, 0, 0, 4}, RealBall{0, 0, -7, 4}, RealBall{2, 3, 6, 4}}) {
    const SliceMeasures measures = measure_by_slices({{0, 0, 0, 5}, second});
    expect_near(measures.ball_area[0], first_area, 1e-15L);
    expect_near(measures.ball_area[1], second_area, 1e-15L);
    expect_near(measures.volume, volume, 1e-15L);
  }
}

TEST(SliceQuadrature, VectorAreasOfTwoOverlappingBalls) {
  // The free part of a sphere and the disc that the circle bounds are a closed surface: its vector area is zero.
  const Real h = (49.0L + 25 - 16) / 14;
  const Real disc = pi * (5 - h) * (5 + h);
  const std::array<Real, 3> direction = {2.0L / 7, 3.0L / 7, 6.0L / 7};
  const SliceMeasures measures = measure_by_slices({{1, 0, -1, 5}, {3, 3, 5, 4}});
  for (size_t k = 0; k < 3; ++k) {
    expect_near(measures.ball_vector_area[0][k], -disc * direction[k], 1e-15L);
    expect_near(measures.ball_vector_area[1][k], disc * direction[k], 1e-15L);
  }
}

TEST(SliceQuadrature, VectorAreasSumToZero) {
  RandomSource random(9);
  for (int k = 0; k < 4; ++k) {
    const Balls balls = loose_balls(random, 15);
    const SliceMeasures measures = measure_by_slices(real_balls(balls));
    std::array<Real, 3> sum = {0, 0, 0};
    for (const std::array<Real, 3> &part : measures.ball_vector_area)
      for (size_t c = 0; c < 3; ++c) sum[c] += part[c];
    for (const Real component : sum) EXPECT_LE(std::abs(component), 1e-14L * measures.area) << to_text(balls);
  }
}

TEST(SliceQuadrature, ContainedEqualAndTangentBalls) {
  const SliceMeasures measures =
      measure_by_slices({{0, 0, 0, 5}, {3, 0, 0, 2}, {0, 0, 0, 5}, {0, 1, 1, 1}, {0, 10, 0, 5}, {0, 0, 0, 4}});
  expect_near(measures.ball_area[0], 100 * pi, 1e-15L);
  for (const size_t inside : {1U, 2U, 3U, 5U}) EXPECT_LT(std::abs(measures.ball_area[inside]), 1e-12L);
  expect_near(measures.volume, 1000 * pi / 3, 1e-15L);
}

TEST(SliceQuadrature, CubeOfEightBallsWithAVoid) {
  // Centres (+-1, +-1, +-1), radius r: by symmetry each ball loses three caps that overlap only in pairs while
  // r^2 < 2 (the lines x = y = 0 stay free); for r just above 1 the caps of one ball are apart: r = 1.2.
  const Real r = 1.2L;
  std::vector<RealBall> balls;
  for (int k = 0; k < 8; ++k)
    balls.push_back({(k & 1) != 0 ? 1.0L : -1.0L, (k & 2) != 0 ? 1.0L : -1.0L, (k & 4) != 0 ? 1.0L : -1.0L, r});
  const SliceMeasures measures = measure_by_slices(balls);
  expect_near(measures.area, 8 * (4 * pi * r * r - 3 * 2 * pi * r * (r - 1)), 1e-15L);
  expect_near(measures.volume, 8 * (4 * pi / 3 * r * r * r - 3 * pi * (r - 1) * (r - 1) * (2 * r + 1) / 3), 1e-15L);
}

TEST(SliceQuadrature, DoesNotDependOnStepAndDirection) {
  RandomSource random(7);
  for (int k = 0; k < 6; ++k) {
    const Balls balls = k < 3 ? loose_balls(random, 15) : degenerate_balls(random, 9);
    Balls turned;
    for (const LatticeBall &ball : balls) turned.push_back({ball.z, ball.x, ball.y, ball.radius});
    const SliceMeasures coarse = measure_by_slices(real_balls(balls));
    const SliceMeasures fine = measure_by_slices(real_balls(turned), 0.07L);
    expect_near(coarse.area, fine.area, 1e-13L);
    expect_near(coarse.volume, fine.volume, 1e-13L);
    for (size_t i = 0; i < balls.size(); ++i)
      EXPECT_LE(std::abs(coarse.ball_area[i] - fine.ball_area[i]), 1e-13L * fine.area) << to_text(balls);
  }
}

}  // namespace
