// The z-buffer against known discs and depths, and against walks along rays.
#include "z_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_balls.hpp"

namespace {

using namespace oracle;

size_t pixels_of(const std::vector<SeenPixel> &image, uint32_t ball) {
  size_t count = 0;
  for (const SeenPixel &pixel : image) count += pixel.ball == ball ? 1 : 0;
  return count;
}

TEST(ZBuffer, ShowsADiscOfTheRightSizeAndHeight) {
  const std::vector<PlainBall> balls = {{{3, -2, 7}, 5}};
  const PixelGrid grid = grid_around(balls, 400);
  const auto image = z_buffer(balls, grid);
  const double area = static_cast<double>(pixels_of(image, 0)) * grid.side * grid.side;
  EXPECT_NEAR(area, 25 * std::numbers::pi, 0.02);
  double highest = 0;
  for (const SeenPixel &pixel : image) highest = std::max(highest, pixel.depth);
  EXPECT_NEAR(highest, 12, 1e-3);
  EXPECT_DOUBLE_EQ(front_of(balls[0], 6, 2), 7);  // 3 4 5
  EXPECT_DOUBLE_EQ(front_of(balls[0], 3, 1), 11);
}

TEST(ZBuffer, CutsEqualBallsInTheMiddleAndHidesTheFartherOne) {
  const std::vector<PlainBall> side_by_side = {{{-3, 0, 0}, 5}, {{3, 0, 0}, 5}};
  const PixelGrid grid = grid_around(side_by_side, 300);
  const auto image = z_buffer(side_by_side, grid);
  for (size_t k = 0; k < grid.pixels(); ++k)
    if (image[k].ball != no_ball) {
      EXPECT_EQ(image[k].ball, grid.x(k % grid.columns) < 0 ? 0U : 1U);
      EXPECT_GE(image[k].depth, image[k].runner_up);
    }

  const std::vector<PlainBall> behind = {{{0, 0, 0}, 5}, {{0, 0, 20}, 5}, {{0, 0, 10}, 4}};
  for (const SeenPixel &pixel : z_buffer(behind, grid_around(behind, 100))) {
    EXPECT_TRUE(pixel.ball == 1 || pixel.ball == no_ball);
    EXPECT_TRUE(!std::isfinite(pixel.runner_up) || (pixel.runner_up <= 14 && pixel.runner_up >= 0));
  }
}

TEST(ZBuffer, AgreesWithWalksAlongRays) {
  RandomSource random(1);
  const std::vector<PlainBall> balls = plain_balls(loose_balls(random, 30), 1);
  const ViewAxes axes{{10, 20, 30}, {0.6, 0, -0.8}, {0, 1, 0}, {0.8, 0, 0.6}};
  const std::vector<PlainBall> seen = seen_along(balls, axes);
  const PixelGrid grid = grid_around(seen, 40);
  const auto image = z_buffer(seen, grid);
  for (size_t k = 0; k < grid.pixels(); ++k) {
    // The first point that is in a ball, walking away from the viewer in small steps in the balls' own coordinates.
    const double x = grid.x(k % grid.columns);
    const double y = grid.y(k / grid.columns);
    double found = -1e9;
    for (double z = 600; z > -600 && found < -1e8; z -= 1)
      for (const PlainBall &ball : balls) {
        double square = 0;
        for (size_t c = 0; c < 3; ++c)
          square +=
              std::pow(axes.origin[c] + x * axes.right[c] + y * axes.up[c] + z * axes.towards[c] - ball.centre[c], 2);
        if (square <= ball.radius * ball.radius) found = z;
      }
    if (image[k].ball == no_ball) {
      EXPECT_LT(found, -1e8);
      continue;
    }
    // The walk can step over a thin part of a ball, so the front may be nearer than what is found.
    EXPECT_GE(image[k].depth, found - 1e-9);
    const bool thin = image[k].depth - seen[image[k].ball].centre[2] < 1;
    EXPECT_TRUE(thin || image[k].depth <= found + 1);
    std::vector<double> fronts;
    for (const PlainBall &ball : seen) fronts.push_back(front_of(ball, x, y));
    std::sort(fronts.begin(), fronts.end());
    EXPECT_EQ(image[k].depth, fronts[fronts.size() - 1]);
    EXPECT_EQ(image[k].runner_up, fronts[fronts.size() - 2]);
  }
}

TEST(ZBuffer, SeesNothingOfBallsOfRadiusZero) {
  const std::vector<PlainBall> points = {{{0, 0, 0}, 0}, {{1, 1, 1}, 0}};
  for (const SeenPixel &pixel : z_buffer(points, grid_around(points, 20))) EXPECT_EQ(pixel.ball, no_ball);
  EXPECT_EQ(z_buffer({}, grid_around({}, 5)).size(), 25U);
}

}  // namespace
