// The rest of single chords, in doubles and exactly, against clipping in long doubles.
#include "contacts/chord_clipper.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

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

// By the two other balls of a chord, those that clip it.
using Chords = std::map<std::array<uint32_t, 2>, std::array<uint32_t, 2>>;

Chords chords_of(const hsp::Caps &caps, hsp::ChordClipper &clipper) {
  Chords chords;
  clipper.start(caps);
  const auto ball = [&](uint32_t cap) { return cap == hsp::no_id ? cap : caps.ball[cap]; };
  for (uint32_t j = 0; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      hsp::ChordEnds ends;
      if (clipper.clip(caps, j, k, ends)) {
        chords[{caps.ball[j], caps.ball[k]}] = {ball(ends.clipper[0]), ball(ends.clipper[1])};
      }
    }
  }
  return chords;
}

// The caps of one ball, all or those of later balls, that may touch its power cell, however few there are.
TEST(ChordClipper, LeavesTheSameWithTheCapsThatStay) {
  oracle::RandomSource random(82);
  uint32_t chords = 0, dropped = 0, empty = 0, inside = 0;
  for (int set = 0; set < 280 && !HasFailure(); ++set) {
    const size_t n = static_cast<size_t>(random.in(2, set % 2 == 0 ? 30 : 14));
    const oracle::Balls balls = set % 2 == 0 ? oracle::dense_balls(random, n) : oracle::any_balls(random, n);
    const BuiltGrid built(oracle::in_lengths(balls, 1));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::BallSet &all = built.grid().balls();
    const uint32_t capacity = static_cast<uint32_t>(balls.size()) + 2;
    CarvedMemory caps_memory, clipper_memory;
    hsp::Caps caps;
    hsp::ChordClipper clipper;
    caps_memory.carve(caps, capacity);
    clipper_memory.carve(clipper, capacity);
    const auto is_contained = [&](uint32_t j) {
      for (uint32_t k = 0; k < all.n; ++k) {
        if (hsp::lies_inside(all, j, k)) return true;
      }
      return false;
    };
    for (uint32_t i = 0; i < all.n; ++i) {
      for (const bool later : {false, true}) {
        caps.gather(all, built.grid().block_around(built.grid().cube_at(all.ball(i).centre)), i, nullptr);
        if (caps.contained || !(all.r[i] > 0)) break;
        caps.keep_if([&](uint32_t j) { return (j > i || !later) && !is_contained(j); });
        const Chords expected = chords_of(caps, clipper);
        hsp::ExposedCaps exposed = clipper.exposed_caps();
        if (!exposed.find(hsp::ExposedCaps::Part::ball, caps)) {
          EXPECT_TRUE(expected.empty()) << oracle::to_text(balls);
          ++empty;
          continue;
        }
        const uint32_t before = caps.count;
        caps.keep(exposed.kept());
        EXPECT_EQ(chords_of(caps, clipper), expected) << oracle::to_text(balls);
        dropped += before - caps.count;
        chords += static_cast<uint32_t>(expected.size());
        inside += expected.empty() || exposed.find(hsp::ExposedCaps::Part::sphere, caps) ? 0U : 1U;
      }
    }
  }
  EXPECT_GT(chords, 10000U);
  EXPECT_GT(dropped, 10000U);
  EXPECT_GT(empty, 50U);
  EXPECT_GT(inside, 50U);  // power cells that do not reach the sphere
}

}  // namespace
