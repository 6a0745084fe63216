// Points of cylinders in space against the formulas for what is seen of them, and closest points against samples.
#include "maps/stick_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_balls.hpp"

namespace {

hsp::Vec3 random_point(oracle::RandomSource &random, int64_t size) {
  const oracle::LatticeBall at = oracle::ball_in_box(random, size, 1, 1);
  return {static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)};
}

TEST(Stick, HasItsFrontOnTheCylinder) {
  oracle::RandomSource random(41);
  for (int time = 0; time < 2000; ++time) {
    hsp::PlacedBall foot{random_point(random, 1000), 90}, top{random_point(random, 1000), 120};
    if (foot.centre.z > top.centre.z) std::swap(foot.centre.z, top.centre.z);
    if (std::hypot(top.centre.x - foot.centre.x, top.centre.y - foot.centre.y) < 1) continue;
    const hsp::Stick stick = hsp::stick_between(foot, top, 60);
    const double s = 0.3 * stick.length;
    const hsp::ProjectedEllipse circle = stick.circle_at(s);
    for (int k = 0; k <= 16; ++k) {
      const double t = hsp::pi * k / 16;
      // The point of the half circle, its height from the room's formula.
      const hsp::Vec3 q{circle.centre[0] + std::cos(t) * circle.major[0] + std::sin(t) * circle.minor[0],
                        circle.centre[1] + std::cos(t) * circle.major[1] + std::sin(t) * circle.minor[1],
                        stick.on_axis(s).z + 60 * stick.seen * std::sin(t)};
      const hsp::Vec3 from_foot = q - foot.centre;
      const double along = hsp::dot(from_foot, stick.axis);
      const hsp::Vec3 beside = hsp::combine(1.0, from_foot, -along, stick.axis);
      EXPECT_NEAR(along, s, 1e-9);
      EXPECT_NEAR(std::sqrt(hsp::dot(beside, beside)), 60, 1e-9);
      // Nothing of the cylinder is above it.
      const hsp::Vec3 higher =
          hsp::combine(1.0, beside, 1e-3,
                       {-stick.axis.z * stick.axis.x, -stick.axis.z * stick.axis.y, 1.0 - stick.axis.z * stick.axis.z});
      EXPECT_GT(std::sqrt(hsp::dot(higher, higher)), 60);
      const double a = from_foot.x * stick.e[0] + from_foot.y * stick.e[1];
      const double w = from_foot.y * stick.e[0] - from_foot.x * stick.e[1];
      const double v = std::sqrt(std::max(0.0, 3600 - w * w));
      EXPECT_NEAR((a + stick.axis.z * v) / stick.seen, s, 1e-3);
      EXPECT_NEAR((a * stick.axis.z + v) / stick.seen, from_foot.z, 1e-3);
    }
    // Junction circles lie on the balls.
    const hsp::Vec3 leaves = stick.on_axis(stick.first) - foot.centre;
    EXPECT_NEAR(hsp::dot(leaves, leaves) + 3600, 8100, 1e-6);
    const hsp::Vec3 enters = stick.on_axis(stick.last) - top.centre;
    EXPECT_NEAR(hsp::dot(enters, enters) + 3600, 14400, 1e-6);
  }
}

TEST(Segment, FindsClosestPoints) {
  oracle::RandomSource random(42);
  for (int time = 0; time < 3000; ++time) {
    const int64_t size = time % 2 == 0 ? 3 : 100;
    hsp::Segment a{}, b{};
    a.from = random_point(random, size);
    a.to = time % 5 == 0 ? a.from : random_point(random, size);
    b.from = random_point(random, size);
    b.to = time % 7 == 0 ? b.from : time % 11 == 0 ? b.from + (a.to - a.from) : random_point(random, size);
    const hsp::ClosestPoints found = hsp::closest_points(a, b);
    if (time % 7 == 0) {
      const hsp::ClosestPoints same = hsp::closest_points(a, b.from);
      ASSERT_EQ(same.first, found.first);
      ASSERT_EQ(same.squared, found.squared);
    }
    const auto squared = [&](double s, double t) {
      const hsp::Vec3 d = b.at(t) - a.at(s);
      return hsp::dot(d, d);
    };
    ASSERT_GE(found.first, 0);
    ASSERT_LE(found.first, 1);
    ASSERT_GE(found.second, 0);
    ASSERT_LE(found.second, 1);
    EXPECT_NEAR(found.squared, squared(found.first, found.second), 1e-9);
    for (int s = 0; s <= 20; ++s)
      for (int t = 0; t <= 20; ++t) ASSERT_GE(squared(s / 20.0, t / 20.0), found.squared - 1e-9 * (1 + found.squared));
  }
}

}  // namespace
