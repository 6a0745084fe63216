#include "maps/ball_scene.hpp"

#include <gtest/gtest.h>

#include "placed_balls.hpp"

namespace {

using hsp::Crease;
using hsp::SeenBall;
using hsp::Vec3;

double distance(const SeenBall &ball, const Vec3 &p) {
  return std::hypot(ball.x - p.x, ball.y - p.y, ball.z - p.z);
}

TEST(Curves, CreasesLieOnBothSpheresWithTheNearerBallOnTheLeft) {
  oracle::RandomSource random(7);
  int whole = 0, part = 0, none = 0;
  for (int time = 0; time < 3000; ++time) {
    PlacedBalls placed(oracle::balls_in_box(random, 2, 30, 5, 30), {2, 1, -1});
    const auto balls = placed.seen.balls();
    if (balls.size() < 2) continue;
    const uint32_t near = placed.seen.is_nearer(0, 1) ? 0 : 1;
    const SeenBall &i = balls[1 - near];
    const SeenBall &j = balls[near];
    const Crease crease(i, j);
    const double apart = distance(i, {j.x, j.y, j.z});
    if (apart > i.r + j.r || apart < std::abs(i.r - j.r)) {
      EXPECT_FALSE(crease.exists);
      continue;
    }
    if (!crease.exists) {
      // All of it lies below the nearer centre.
      EXPECT_LE(crease.m.z + crease.rise, j.z + 1e-9);
      ++none;
      continue;
    }
    ++(crease.is_whole() ? whole : part);
    for (int k = -8; k <= 8; ++k) {
      const double t = crease.end * k / 8;
      const Vec3 p = crease.at(t);
      EXPECT_NEAR(distance(i, p), i.r, 1e-9);
      EXPECT_NEAR(distance(j, p), j.r, 1e-9);
      EXPECT_GE(p.z, j.z - 1e-9);
      EXPECT_NEAR(p.z, crease.m.z + crease.rise * std::cos(t), 1e-9);
      if (!crease.is_whole() && (k == 8 || k == -8)) {
        EXPECT_NEAR(p.z, j.z, 1e-9);
      }
      // A step to the left of the direction of travel: ball j is the higher one there.
      const Vec3 q = crease.at(t + 1e-4);
      const Vec3 left{p.x - (q.y - p.y), p.y + (q.x - p.x), 0};
      const auto front = [&](const SeenBall &ball) {
        const double squared =
            ball.r * ball.r - (left.x - ball.x) * (left.x - ball.x) - (left.y - ball.y) * (left.y - ball.y);
        return squared < 0 ? -1e300 : ball.z + std::sqrt(squared);
      };
      if (k > -7 && k < 7) {
        EXPECT_GT(front(j), front(i));
      }
    }
  }
  EXPECT_GT(whole, 5);
  EXPECT_GT(part, 500);
  EXPECT_GT(none, 50);
}

TEST(Curves, SeenAlongTheirAxisAreLevel) {
  const SeenBall low{0, 0, 0, 5, 0, 0}, high{0, 0, 4, 2, 1, 0}, deep{0, 0, 7, 5, 2, 0};
  const Crease crease(low, high);
  ASSERT_TRUE(crease.exists);
  EXPECT_TRUE(crease.is_whole());
  EXPECT_EQ(crease.rise, 0.0);
  EXPECT_NEAR(crease.at(0.5).z, 4.625, 1e-12);
  EXPECT_NEAR(crease.at(0.5).z, crease.at(2.5).z, 1e-12);
  EXPECT_FALSE(Crease(low, deep).exists);  // behind the nearer ball
}

TEST(Curves, BehindIsInTheBallOrBelowIt) {
  const SeenBall ball{1, 2, 3, 5, 0, 0};
  EXPECT_GT(hsp::depth_behind({1, 2, 3}, ball), 0.0);
  EXPECT_GT(hsp::depth_behind({1, 2, 7.9}, ball), 0.0);
  EXPECT_LE(hsp::depth_behind({1, 2, 8.1}, ball), 0.0);
  EXPECT_GT(hsp::depth_behind({1, 2, -100}, ball), 0.0);
  EXPECT_GT(hsp::depth_behind({5.9, 2, -100}, ball), 0.0);
  EXPECT_LE(hsp::depth_behind({5.9, 2, 6}, ball), 0.0);
  EXPECT_LE(hsp::depth_behind({6.1, 2, -100}, ball), 0.0);
  const Vec3 p = hsp::silhouette_point(ball, 0.5);
  EXPECT_NEAR(p.x, 1 + 5 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(p.y, 2 + 5 * std::sin(0.5), 1e-12);
  EXPECT_EQ(p.z, 3.0);
}

// Balls that touch, and balls of which the nearer one is touched where its silhouette is, have no crease, whatever
// roundings make of their coordinates.
TEST(Curves, TouchingBallsHaveNoCreases) {
  for (int64_t a = -4; a <= 4; ++a)
    for (int64_t b = -4; b <= 4; ++b) {
      const std::array<double, 3> towards = {static_cast<double>(a), static_cast<double>(b), 3};
      for (const int64_t r : {1, 2, 4}) {
        PlacedBalls apart({{1, 2, 3, r}, {3, 5, 9, 7 - r}}, towards);
        if (apart.seen.balls().size() < 2) continue;
        EXPECT_FALSE(Crease(apart.seen.balls()[0], apart.seen.balls()[1]).exists);
        EXPECT_FALSE(Crease(apart.seen.balls()[1], apart.seen.balls()[0]).exists);
      }
    }
  // (3, 0, 4) is the highest point of the circle, and on the silhouette of the nearer ball.
  const auto with_centre_at = [](double z) { return Crease({0, 0, 0, 5, 0, 0}, {5, 0, z, 2, 1, 0}); };
  for (const double off : {0.0, 1e-15, -1e-15, 1e-13, -1e-13}) EXPECT_FALSE(with_centre_at(4 + off).exists);
  EXPECT_FALSE(with_centre_at(4.01).exists);
  EXPECT_TRUE(with_centre_at(3.99).exists);
}

}  // namespace
