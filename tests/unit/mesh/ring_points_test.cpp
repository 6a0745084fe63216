#include "mesh/ring_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

const auto everywhere = [](double, double) { return true; };

// Everywhere on the sphere there is a point, and none has another one too near it.
TEST(RingPoints, CoverTheSphereEvenly) {
  for (const double spacing : {0.7, 0.2, 0.05}) {
    std::vector<hsp::Vec3> points;
    hsp::for_each_ring_point(spacing, everywhere, [&](const hsp::Vec3 &p) { points.push_back(p); });
    const double expected = hsp::expected_ring_points(spacing);
    EXPECT_NEAR(static_cast<double>(points.size()), expected, 0.2 * expected) << spacing;
    double nearest = 4.0;
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(dot(points[i], points[i]), 1.0, 1e-12);
      for (size_t j = 0; j < i; ++j) nearest = std::min(nearest, dot(points[i] - points[j], points[i] - points[j]));
    }
    EXPECT_GT(std::sqrt(nearest), 0.5 * spacing);
    double farthest = 0.0;
    hsp::for_each_ring_point(0.23, everywhere, [&](const hsp::Vec3 &place) {
      double least = 4.0;
      for (const hsp::Vec3 &p : points) least = std::min(least, dot(place - p, place - p));
      farthest = std::max(farthest, least);
    });
    EXPECT_LT(std::sqrt(farthest), 0.9 * spacing) << spacing;
  }
}

// Those of the other circles are the same.
TEST(RingPoints, CirclesThatAreNotNeededAreLeftOut) {
  for (const double spacing : {0.3, 0.01}) {
    const auto is_needed = [](double cosine) { return cosine > 0.2 && cosine < 0.4; };
    std::vector<hsp::Vec3> all, some;
    hsp::for_each_ring_point(spacing, everywhere, [&](const hsp::Vec3 &p) {
      if (is_needed(p.z)) all.push_back(p);
    });
    uint32_t others = 0;
    hsp::for_each_ring_point(
        spacing, [&](double, double cosine) { return is_needed(cosine); },
        [&](const hsp::Vec3 &p) {
          if (is_needed(p.z)) some.push_back(p);
          others += is_needed(p.z) ? 0 : 1;
        });
    ASSERT_EQ(some.size(), all.size());
    for (size_t k = 0; k < all.size(); ++k) EXPECT_EQ(some[k].x, all[k].x);
    if (spacing == 0.01) {
      EXPECT_LT(others, 20000U) << "on circles near the poles, which have few points";
    }
  }
}

TEST(RingPoints, LargeDistancesYieldAFewPoints) {
  int points = 0;
  hsp::for_each_ring_point(1e30, everywhere, [&](const hsp::Vec3 &) { ++points; });
  EXPECT_GT(points, 2);
  EXPECT_LT(points, 20);
}

}  // namespace
