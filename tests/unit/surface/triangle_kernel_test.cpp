// The kernels over probes and their triangles for registers of one, two and four doubles: the same bits from each, and
// what they mean against vectors computed one by one.
#include "surface/triangle_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "core/elementary.hpp"
#include "core/vec3.hpp"
#include "runnable_targets.hpp"

namespace {

using hsp::ProbeTriangles;
using hsp::Vec3;

// Balls at random, and four of their triples.
class RandomTriples {
 public:
  explicit RandomTriples(std::mt19937 &random) {
    std::uniform_real_distribution<double> fraction(0.0, 1.0);
    for (uint32_t j = 0; j < 8; ++j) {
      x_.push_back(std::floor(3000 * fraction(random)));
      y_.push_back(std::floor(3000 * fraction(random)));
      z_.push_back(std::floor(3000 * fraction(random)));
      r_.push_back(std::floor(1000 + 1500 * fraction(random)));
    }
    for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
      const uint32_t first = static_cast<uint32_t>(random() % 6);
      for (uint32_t k = 0; k < 3; ++k) triangles_.ball[k][lane] = first + k;
      triangles_.sign[lane] = random() % 2 == 0 ? 1 : -1;
      triangles_.root_discriminant[lane] = root_discriminant(first);
    }
  }
  [[nodiscard]] hsp::BallArrays balls() const { return {x_.data(), y_.data(), z_.data(), r_.data()}; }
  [[nodiscard]] const ProbeTriangles &triangles() const { return triangles_; }
  [[nodiscard]] Vec3 centre(uint32_t ball) const { return {x_[ball], y_[ball], z_[ball]}; }
  [[nodiscard]] double radius(uint32_t ball) const { return r_[ball]; }

 private:
  // 4 R^2 n.n - q.q as exact/plane.hpp has it; not a number where the circles do not cross.
  [[nodiscard]] double root_discriminant(uint32_t first) const {
    const auto height = [&](const Vec3 &v, uint32_t other) {
      return dot(v, v) + (r_[first] - r_[other]) * (r_[first] + r_[other]);
    };
    const Vec3 v = centre(first + 1) - centre(first);
    const Vec3 w = centre(first + 2) - centre(first);
    const Vec3 n = cross(v, w);
    const Vec3 q = combine(height(v, first + 1), w, -height(w, first + 2), v);
    return std::sqrt(4 * r_[first] * r_[first] * dot(n, n) - dot(q, q));
  }

  std::vector<double> x_, y_, z_, r_;
  ProbeTriangles triangles_{};
};

struct Kernel {
  std::function<void(const hsp::BallArrays &, ProbeTriangles &)> place, measure;

  [[nodiscard]] ProbeTriangles run(const RandomTriples &triples) const {
    ProbeTriangles found = triples.triangles();
    place(triples.balls(), found);
    measure(triples.balls(), found);
    return found;
  }
};
template <uint32_t n>
Kernel kernel() {
  return {hsp::TriangleKernel<n>::place, hsp::TriangleKernel<n>::measure};
}
Kernel kernel_of(hsp::Target target) {
  return {[=](const hsp::BallArrays &balls, ProbeTriangles &t) { hsp::place_probes(target, balls, t); },
          [=](const hsp::BallArrays &balls, ProbeTriangles &t) { hsp::measure_triangles(target, balls, t); }};
}

template <size_t rows>
void expect_same(const double (&a)[rows][ProbeTriangles::lanes], const double (&b)[rows][ProbeTriangles::lanes]) {
  for (size_t row = 0; row < rows; ++row) {
    for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
      const double p = a[row][lane];
      const double q = b[row][lane];
      if (p != p && q != q) continue;
      EXPECT_EQ(std::memcmp(&p, &q, sizeof p), 0) << p << " " << q;
    }
  }
}
void expect_same(const ProbeTriangles &a, const ProbeTriangles &b) {
  expect_same(a.offset, b.offset);
  for (int k = 0; k < 3; ++k) {
    expect_same(a.corner[k], b.corner[k]);
    expect_same(a.inward[k], b.inward[k]);
  }
  expect_same(a.cosine, b.cosine);
  expect_same(a.vector_area, b.vector_area);
  for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
    if (a.offset[0][lane] != a.offset[0][lane]) continue;
    EXPECT_EQ(a.side_error[lane], b.side_error[lane]);
    EXPECT_EQ(a.steradians[lane], b.steradians[lane]);
  }
}

TEST(TriangleKernel, GivesTheSameBitsForEveryWidth) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    const RandomTriples triples(random);
    const ProbeTriangles two = kernel<2>().run(triples);
    expect_same(kernel<1>().run(triples), two);
    for (const hsp::Target target : runnable_targets()) expect_same(kernel_of(target).run(triples), two);
    if (HasFailure()) return;
  }
}

// Of a vertex: on three spheres; the triangle's corners, sides, area and vector area.
TEST(TriangleKernel, MeasuresTriangles) {
  std::mt19937 random(8);
  uint32_t served = 0;
  for (int round = 0; round < 2000; ++round) {
    const RandomTriples triples(random);
    const ProbeTriangles t = kernel<1>().run(triples);
    for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
      if (t.offset[0][lane] != t.offset[0][lane]) continue;
      ++served;
      const auto vector = [lane](const double(&a)[3][ProbeTriangles::lanes]) {
        return Vec3{a[0][lane], a[1][lane], a[2][lane]};
      };
      const Vec3 vertex = triples.centre(t.ball[0][lane]) + vector(t.offset);
      // The axes of its two circles on the first sphere are far from parallel.
      const Vec3 v = triples.centre(t.ball[1][lane]) - triples.centre(t.ball[0][lane]);
      const Vec3 w = triples.centre(t.ball[2][lane]) - triples.centre(t.ball[0][lane]);
      EXPECT_GT(dot(cross(v, w), cross(v, w)), dot(v, v) * dot(w, w) * (1.0 / 16 - 1e-9));
      Vec3 direction[3];
      for (int k = 0; k < 3; ++k) {
        const Vec3 to = triples.centre(t.ball[k][lane]) - vertex;
        EXPECT_NEAR(std::sqrt(dot(to, to)), triples.radius(t.ball[k][lane]), 1e-8);
        direction[k] = vector(t.corner[k]);
        const Vec3 off = direction[k] - (1 / std::sqrt(dot(to, to))) * to;
        EXPECT_LT(std::sqrt(dot(off, off)), 1e-11);
      }
      const double triple_product = dot(direction[0], cross(direction[1], direction[2]));
      EXPECT_EQ(triple_product<0, t.sign[lane]> 0);
      // The angles of a spherical triangle are those between its sides' planes.
      double area = -hsp::pi;
      Vec3 vector_area{0, 0, 0};
      for (int k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3;
        const int b = (k + 2) % 3;
        const Vec3 inward = vector(t.inward[k]);
        EXPECT_NEAR(dot(inward, inward), 1, 1e-12);
        EXPECT_NEAR(dot(inward, direction[a]), 0, 1e-9);
        EXPECT_NEAR(dot(inward, direction[b]), 0, 1e-9);
        EXPECT_GT(dot(inward, direction[k]), 0);
        EXPECT_NEAR(t.cosine[k][lane], dot(direction[a], direction[b]), 1e-10);
        const double cosine = -dot(vector(t.inward[a]), vector(t.inward[b]));
        area += std::acos(std::fmax(-1, std::fmin(1, cosine)));
        vector_area = vector_area + 0.5 * std::acos(dot(direction[a], direction[b])) * inward;
      }
      EXPECT_NEAR(t.steradians[lane], area, 1e-6);
      const Vec3 off = vector(t.vector_area) - vector_area;
      EXPECT_LT(std::sqrt(dot(off, off)), 1e-6);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(served, 1000U);
}

// A vertex in line with two centres sees no triangle.
TEST(TriangleKernel, SidesWithoutDirection) {
  const double x[] = {-1000, 1000, 0};
  const double y[] = {0, 0, 800};
  const double z[] = {0, 0, 0};
  const double r[] = {1000, 1000, 800};
  ProbeTriangles t{};
  for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
    for (uint32_t k = 0; k < 3; ++k) t.ball[k][lane] = k;
    t.sign[lane] = 1;
    t.offset[0][lane] = 1000;
  }
  hsp::measure_triangles(hsp::Target::baseline, {x, y, z, r}, t);
  for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
    EXPECT_EQ(t.steradians[lane], -1);
    EXPECT_EQ(t.vector_area[0][lane], 0);
  }
}

}  // namespace
