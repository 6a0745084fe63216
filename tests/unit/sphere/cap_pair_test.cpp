// The floating-point stage of the vertex search against the exact stage: whenever it is certain, the exact predicates
// agree; and the distance of the computed points from third caps is within the stated error of a longer evaluation.
#include "cap_pair_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "expect_cases.hpp"
#include "gridless_balls.hpp"
#include "random_balls.hpp"
#include "sphere/caps.hpp"

namespace {

using namespace hsp;

// Caps of one sphere from given balls, made by the library itself.
struct CapsOf {
  explicit CapsOf(const std::vector<exact::LatticeBall> &balls) {
    const uint32_t n = static_cast<uint32_t>(balls.size());
    for (const exact::LatticeBall &ball : balls) gridless.add(ball);
    Workspace measure;
    caps.carve(measure, n);
    memory.resize(measure.bytes());
    Workspace workspace(memory.data(), memory.size());
    caps.carve(workspace, n);
    CubeBlock block;
    block.range[0] = {0, n};
    block.ranges = 1;
    caps.gather(gridless.set(), block, 0, nullptr);
  }
  GridlessBalls<8> gridless;
  std::vector<unsigned char> memory;
  Caps caps;
};

// u.p - b of cap l for the point p+ or p- of caps j and k, in long double from the integers.
long double depth(const Caps &caps, uint32_t j, uint32_t k, uint32_t l, int sign) {
  const exact::Plane P = caps.plane(j);
  const exact::Plane Q = caps.plane(k);
  const exact::Plane R = caps.plane(l);
  const exact::Vector normal = cross(P.v, Q.v);
  using Long = std::array<long double, 3>;
  const auto from = [](const exact::Vector &v) {
    return Long{static_cast<long double>(v.x), static_cast<long double>(v.y), static_cast<long double>(v.z)};
  };
  const Long n = from(normal), u = from(P.v), v = from(Q.v), w = from(R.v);
  const auto inner = [](const Long &a, const Long &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const long double N = inner(n, n);
  const long double root = std::sqrt(static_cast<long double>(exact::Exact::discriminant(caps.sphere, P, Q)));
  Long q, p;
  for (size_t a = 0; a < 3; ++a) q[a] = static_cast<long double>(P.h) * v[a] - static_cast<long double>(Q.h) * u[a];
  for (size_t a = 0; a < 3; ++a) {
    const size_t b = (a + 1) % 3, c = (a + 2) % 3;
    p[a] = (q[b] * n[c] - q[c] * n[b] + sign * root * n[a]) / N;
  }
  const long double diameter = std::sqrt(static_cast<long double>(caps.sphere.W));
  return (inner(p, w) - static_cast<long double>(R.h)) / (diameter * std::sqrt(inner(w, w)));
}

TEST(CapPair, Cases) {
  expect_cases(cases::sphere_cap_pair);
}

TEST(CapPair, CertainAnswersAreRight) {
  oracle::RandomSource random(11);
  int points = 0, better = 0;
  double worst[2] = {0.0, 0.0};
  for (int set = 0; set < 20000; ++set) {
    const int64_t size = set % 4 == 0 ? 6 : set % 4 == 1 ? 1000 : 300000000;
    std::vector<exact::LatticeBall> balls;
    for (uint32_t k = 0; k < 8; ++k) {
      balls.push_back(
          {{random.in(-size, size), random.in(-size, size), random.in(-size, size)}, random.in(size / 2, size), k});
    }
    // Nearly parallel axes, where the points are ill-conditioned.
    if (set % 5 == 0) {
      for (uint32_t k = 2; k < 8; ++k) {
        balls[k].centre = balls[1].centre;
        balls[k].centre.x += random.in(-3, 3) * (1 + size / 100000);
        balls[k].centre.y += random.in(-3, 3) * (1 + size / 100000);
      }
    }
    // Planes that nearly agree and cross.
    if (set % 5 == 1) {
      const int64_t step = 1 + size / (set % 2 == 0 ? 2000 : 50);
      for (uint32_t k = 2; k < 8; ++k) {
        balls[k] = {balls[1].centre, balls[1].radius, k};
        balls[k].centre.x += random.in(-step, step);
        balls[k].centre.y += random.in(-step, step);
        balls[k].centre.z += random.in(-step, step);
      }
    }
    const CapsOf own(balls);
    const Caps &caps = own.caps;
    if (caps.contained) continue;
    const exact::Predicates predicates = caps.predicates();
    for (uint32_t j = 0; j < caps.count; ++j) {
      for (uint32_t k = j + 1; k < caps.count; ++k) {
        const CapPair pair(caps, j, k);
        const bool crossing = predicates.crossing(caps.plane(j), caps.plane(k)).sign > 0;
        if (pair.certainly_cross()) {
          ASSERT_TRUE(crossing);
        }
        if (pair.certainly_apart()) {
          ASSERT_FALSE(crossing);
          const bool inside = predicates.side(caps.plane(j), caps.plane(k)).sign > 0;
          const bool contains = predicates.side(caps.plane(k), caps.plane(j)).sign > 0;
          if (pair.certainly_inside()) {
            ASSERT_TRUE(inside);
          }
          if (pair.certainly_contains()) {
            ASSERT_TRUE(contains);
          }
          if (pair.certainly_separate()) {
            ASSERT_FALSE(inside || contains);
          }
        }
        if (!pair.certainly_cross()) continue;
        const CrossingPoints both[2] = {CrossingPoints(caps, j, k, pair), CrossingPoints(caps, j, k)};
        better += both[0].error > 0x1p-24 && both[1].error < both[0].error ? 1 : 0;
        for (uint32_t l = 0; l < caps.count; ++l) {
          if (l == j || l == k) continue;
          const exact::PointStatus status = predicates.point_status(caps.plane(j), caps.plane(k), caps.plane(l));
          for (int formula = 0; formula < 2; ++formula) {
            const CrossingPoints &computed = both[formula];
            for (int point = 0; point < 2; ++point) {
              const double value = computed.x[point] * caps.ux[l] + computed.y[point] * caps.uy[l] +
                                   computed.z[point] * caps.uz[l] - caps.b[l];
              if (value > computed.error) {
                ASSERT_GT(status.side[point], 0);
              }
              if (value < -computed.error) {
                ASSERT_LT(status.side[point], 0);
              }
              const long double exact_value = depth(caps, j, k, l, point == 1 ? 1 : -1);
              const double off = static_cast<double>(std::fabs(value - exact_value)) / computed.error;
              worst[formula] = std::max(worst[formula], off);
              ++points;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(points, 200000);
  EXPECT_GT(better, 10000);
  for (const double most : worst) {
    EXPECT_LT(most, 1.0) << "the stated error bound was exceeded";
    EXPECT_GT(most, 0.001) << "the stated error bound is far too wide to be a filter";
  }
}

}  // namespace
