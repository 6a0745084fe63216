// The brute-force boundary against the nerve, against known topology, and against the points of its arcs.
#include "brute_boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "named_balls.hpp"
#include "nerve.hpp"
#include "random_balls.hpp"

namespace {

using namespace oracle;

TEST(BruteBoundary, HasTheTopologyOfTheNerve) {
  RandomSource random(4);
  for (int k = 0; k < 4000; ++k) {
    const Balls balls = degenerate_balls(random, static_cast<size_t>(random.in(1, 9)));
    const BoundaryRecord record = brute_boundary(balls);
    const std::array<int64_t, 3> betti = nerve_betti_numbers(balls);
    EXPECT_EQ(record.counts.components, betti[0]) << to_text(balls);
    EXPECT_EQ(record.counts.voids, betti[2]) << to_text(balls);
    EXPECT_EQ(record.counts.euler, 2 * (betti[0] - betti[1] + betti[2])) << to_text(balls);
  }
}

TEST(BruteBoundary, HasTheTopologyOfTheNerveWithNestedLoopsAndTies) {
  RandomSource random(8);
  for (int k = 0; k < 100; ++k) {
    const Balls balls = crowned_balls(random, static_cast<size_t>(random.in(9, 26)));
    const BoundaryRecord record = brute_boundary(balls);
    const std::array<int64_t, 3> betti = nerve_betti_numbers(balls);
    EXPECT_EQ(record.counts.components, betti[0]) << to_text(balls);
    EXPECT_EQ(record.counts.voids, betti[2]) << to_text(balls);
    EXPECT_EQ(record.counts.euler, 2 * (betti[0] - betti[1] + betti[2])) << to_text(balls);
  }
}

TEST(BruteBoundary, HasTheTopologyBuiltIn) {
  for (const KnownBalls &set : known_balls()) {
    const BoundaryRecord record = brute_boundary(set.balls);
    EXPECT_EQ(record.counts.components, set.components) << set.name;
    EXPECT_EQ(record.counts.voids, set.voids) << set.name;
    if (set.euler) {
      EXPECT_EQ(record.counts.euler, *set.euler) << set.name;
    }
  }
}

TEST(BruteBoundary, DoesNotDependOnTheOrderOfTheBalls) {
  RandomSource random(5);
  for (int k = 0; k < 300; ++k) {
    const Balls balls = any_balls(random, static_cast<size_t>(random.in(2, 9)));
    const Balls mixed = permuted(balls, random.permutation(balls.size()));
    const auto expected = canonical(brute_boundary(balls), tie_ranks(balls));
    EXPECT_EQ(differences(canonical(brute_boundary(mixed), tie_ranks(mixed)), expected), "") << to_text(balls);
  }
}

using Point = std::array<double, 3>;

// The point of a vertex, from the plane of its centres and the height above it.
Point position(const Balls &balls, const BoundaryRecord::Vertex &vertex) {
  const LatticeBall &a = balls[vertex.ball[0]];
  const auto real = [](const Vector &v) {
    return Point{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
  };
  const auto dot_product = [](const Point &p, const Point &q) {
    return std::inner_product(p.begin(), p.end(), q.begin(), 0.0);
  };
  const Vector iu = centre_difference(a, balls[vertex.ball[1]]);
  const Vector iv = centre_difference(a, balls[vertex.ball[2]]);
  const Point u = real(iu);
  const Point v = real(iv);
  const Point n = real(cross(iu, iv));
  const auto weight = [&](size_t k) {
    return static_cast<double>(balls[vertex.ball[k]].radius * balls[vertex.ball[k]].radius);
  };
  const double gu = (dot_product(u, u) + weight(0) - weight(1)) / 2;
  const double gv = (dot_product(v, v) + weight(0) - weight(2)) / 2;
  const double uu = dot_product(u, u);
  const double uv = dot_product(u, v);
  const double vv = dot_product(v, v);
  const double det = uu * vv - uv * uv;
  const double s = (gu * vv - gv * uv) / det;
  const double t = (gv * uu - gu * uv) / det;
  Point point;
  for (size_t k = 0; k < 3; ++k) point[k] = s * u[k] + t * v[k];
  const double height = std::sqrt(std::max(0.0, weight(0) - dot_product(point, point)) / det);
  for (size_t k = 0; k < 3; ++k) point[k] += vertex.sign * height * n[k];
  return {point[0] + static_cast<double>(a.x), point[1] + static_cast<double>(a.y),
          point[2] + static_cast<double>(a.z)};
}

TEST(BruteBoundary, ArcsRunOutsideAllBalls) {
  RandomSource random(6);
  size_t arcs = 0;
  for (int k = 0; k < 60; ++k) {
    const Balls balls = random.one_in(2) ? loose_balls(random, 12) : belted_balls(random, 14);
    const BoundaryRecord record = brute_boundary(balls);
    for (const auto &arc : record.arcs) {
      // Arcs between tied vertices may be infinitesimally short: their angle has no sign in floating point.
      if (record.vertices[arc.vertex[0]].tied && record.vertices[arc.vertex[1]].tied) continue;
      const LatticeBall &a = balls[arc.ball[0]];
      const Vector iu = centre_difference(a, balls[arc.ball[1]]);
      const Point axis = {static_cast<double>(iu[0]), static_cast<double>(iu[1]), static_cast<double>(iu[2])};
      const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
      const Point from = position(balls, record.vertices[arc.vertex[0]]);
      const Point to = position(balls, record.vertices[arc.vertex[1]]);
      // Rotate the start about the axis by half the angle to the end.
      const double w = static_cast<double>(a.radius * a.radius - balls[arc.ball[1]].radius * balls[arc.ball[1]].radius);
      const double share = (length * length + w) / (2 * length * length);
      const Point centre = {static_cast<double>(a.x) + share * axis[0], static_cast<double>(a.y) + share * axis[1],
                            static_cast<double>(a.z) + share * axis[2]};
      const Point p = {from[0] - centre[0], from[1] - centre[1], from[2] - centre[2]};
      const Point q = {to[0] - centre[0], to[1] - centre[1], to[2] - centre[2]};
      const Point turned = {(axis[1] * p[2] - axis[2] * p[1]) / length, (axis[2] * p[0] - axis[0] * p[2]) / length,
                            (axis[0] * p[1] - axis[1] * p[0]) / length};
      double angle =
          std::atan2(turned[0] * q[0] + turned[1] * q[1] + turned[2] * q[2], p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
      if (angle < 0) angle += 2 * std::acos(-1.0);
      for (const LatticeBall &ball : balls) {
        const double c = std::cos(angle / 2);
        const double s = std::sin(angle / 2);
        const double dx = centre[0] + c * p[0] + s * turned[0] - static_cast<double>(ball.x);
        const double dy = centre[1] + c * p[1] + s * turned[1] - static_cast<double>(ball.y);
        const double dz = centre[2] + c * p[2] + s * turned[2] - static_cast<double>(ball.z);
        EXPECT_GT(std::sqrt(dx * dx + dy * dy + dz * dz), static_cast<double>(ball.radius) - 1e-6) << to_text(balls);
      }
      ++arcs;
    }
  }
  EXPECT_GT(arcs, 1000U);
}

}  // namespace
