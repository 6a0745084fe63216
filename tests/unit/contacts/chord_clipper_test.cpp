// The rest of single chords, in doubles and exactly, against clipping in long doubles.
#include "contacts/chord_clipper.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_grid.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

namespace {

using Real = long double;

struct Interval {
  Real low, high;
  uint32_t clipper[2];
  Real margin;  // how far any decision is from being another, in units of the chord's own half
};

struct RealPlane {
  Real v[3], h;
};

RealPlane real(const hsp::exact::Plane &plane) {
  return {{static_cast<Real>(plane.v.x), static_cast<Real>(plane.v.y), static_cast<Real>(plane.v.z)},
          static_cast<Real>(plane.h)};
}

void cross(const Real (&a)[3], const Real (&b)[3], Real (&c)[3]) {
  for (int k = 0; k < 3; ++k) c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

Real dot(const Real (&a)[3], const Real (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Of caps whose circles cross; false if they do not.
bool clip(const hsp::Caps &caps, uint32_t j, uint32_t k, Interval &interval) {
  const RealPlane P = real(caps.plane(j));
  const RealPlane Q = real(caps.plane(k));
  Real n[3], q[3], m[3];
  cross(P.v, Q.v, n);
  for (int axis = 0; axis < 3; ++axis) q[axis] = P.h * Q.v[axis] - Q.h * P.v[axis];
  cross(q, n, m);
  const Real N = dot(n, n);
  const Real D = static_cast<Real>(caps.sphere.W) * N - dot(q, q);
  if (!(D > 0)) return false;
  const Real root = std::sqrt(D);
  interval = {-root, root, {hsp::no_id, hsp::no_id}, 1};
  for (uint32_t l = 0; l < caps.count; ++l) {
    if (l == j || l == k) continue;
    const RealPlane R = real(caps.plane(l));
    const Real t = -(dot(m, R.v) - N * R.h) / dot(n, R.v);
    const Real gap =
        std::min(std::fabs(std::fabs(t) - root), std::min(std::fabs(t - interval.low), std::fabs(t - interval.high)));
    interval.margin = std::min(interval.margin, gap / root);
    if (dot(n, R.v) > 0 && t < interval.high) {
      interval.high = t;
      interval.clipper[1] = l;
    } else if (dot(n, R.v) < 0 && t > interval.low) {
      interval.low = t;
      interval.clipper[0] = l;
    }
  }
  interval.margin = std::min(interval.margin, std::fabs(interval.high - interval.low) / root);
  return true;
}

TEST(ChordClipper, LeavesWhatLongDoublesLeave) {
  oracle::RandomSource random(81);
  uint32_t left = 0, gone = 0, clipped = 0;
  for (int set = 0; set < 60; ++set) {
    const oracle::Balls balls = oracle::dense_balls(random, 14);
    const BuiltGrid built(oracle::in_lengths(balls, 1));
    CarvedMemory caps_memory, clipper_memory;
    hsp::Caps caps;
    hsp::ChordClipper clipper;
    caps_memory.carve(caps, 14U);
    clipper_memory.carve(clipper, 14U);
    for (uint32_t i = 0; i < built.grid().balls().n; ++i) {
      const hsp::exact::LatticeBall own = built.grid().balls().ball(i);
      caps.gather(built.grid().balls(), built.grid().block_around(built.grid().cube_at(own.centre)), i, nullptr);
      if (caps.contained) continue;
      clipper.start(caps);
      for (uint32_t j = 0; j < caps.count; ++j) {
        for (uint32_t k = j + 1; k < caps.count; ++k) {
          Interval interval;
          hsp::ChordEnds ends;
          const bool is_left = clipper.clip(caps, j, k, ends);
          if (!clip(caps, j, k, interval)) {
            EXPECT_FALSE(is_left);
            continue;
          }
          if (interval.margin < 1e-9L) continue;
          EXPECT_EQ(is_left, interval.low < interval.high);
          ++(is_left ? left : gone);
          if (!is_left) continue;
          for (int end = 0; end < 2; ++end) {
            EXPECT_EQ(ends.clipper[end], interval.clipper[end]);
            clipped += ends.clipper[end] != hsp::no_id ? 1U : 0U;
          }
        }
      }
    }
  }
  EXPECT_GT(left, 500U);
  EXPECT_GT(gone, 5000U);
  EXPECT_GT(clipped, 500U);
}

}  // namespace
