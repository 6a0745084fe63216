// Kinds of points where balls tie, held against cones in integers: directions span space, or a plane, if and only if
// the opposite of each is in the cone that all make up.
#include "pores/tied_balls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tied_sets.hpp"

namespace {

using hsp::no_id;
using hsp::PointKind;
using hsp::TangentPoint;
using oracle::cross;
using oracle::dot;
using oracle::Int128;
using oracle::Vector;

hsp::TangentLines lines;
hsp::Vec3 vectors[16];
const hsp::Span<hsp::Vec3> room(vectors, 16);

Int128 volume(const Vector &a, const Vector &b, const Vector &c) {
  return dot(cross(a, b), c);
}

// Whether v is a sum of non-negative multiples of a, b and c (Cramer), or of two or one of them.
bool is_in_cone(const Vector &v, const Vector &a, const Vector &b, const Vector &c) {
  const Int128 all = volume(a, b, c);
  if (all == 0) return false;
  const int turn = oracle::sign_of(all);
  return turn * oracle::sign_of(volume(v, b, c)) >= 0 && turn * oracle::sign_of(volume(a, v, c)) >= 0 &&
         turn * oracle::sign_of(volume(a, b, v)) >= 0;
}
bool is_in_cone(const Vector &v, const Vector &a, const Vector &b) {
  const Vector n = cross(a, b);
  if (oracle::is_zero(n) || dot(n, v) != 0) return false;
  return dot(cross(v, b), n) >= 0 && dot(cross(a, v), n) >= 0;
}
bool is_in_cone(const Vector &v, const Vector &a) {
  return oracle::is_zero(cross(v, a)) && dot(v, a) > 0;
}
bool is_in_cone(const Vector &v, const std::vector<Vector> &all) {
  for (const Vector &a : all) {
    if (is_in_cone(v, a)) return true;
    for (const Vector &b : all) {
      if (is_in_cone(v, a, b)) return true;
      for (const Vector &c : all) {
        if (is_in_cone(v, a, b, c)) return true;
      }
    }
  }
  return false;
}

PointKind kind_by_cones(const std::vector<Vector> &way) {
  int rank = 0;
  for (const Vector &a : way) {
    for (const Vector &b : way) {
      if (!oracle::is_zero(cross(a, b))) rank = std::max(rank, 2);
      for (const Vector &c : way) rank = volume(a, b, c) != 0 ? 3 : rank;
    }
  }
  if (rank < 2) return PointKind::passing;
  for (const Vector &a : way) {
    if (!is_in_cone({-a[0], -a[1], -a[2]}, way)) return PointKind::passing;
  }
  return rank == 3 ? PointKind::maximum : PointKind::gate;
}

TEST(TiedBalls, KindsAndNames) {
  oracle::RandomSource random(1);
  int kinds[3] = {0, 0, 0}, octahedra = 0;
  for (int turn = 0; turn < 4000; ++turn) {
    const bool flat = random.one_in(3);
    const TiedSet set =
        tied_set(random, static_cast<size_t>(random.in(3, 8)), static_cast<size_t>(random.in(1, 9)), flat);
    const auto n = static_cast<uint32_t>(set.balls.size());
    if (n < 3) continue;
    const PlainBallSet plain(set.balls);
    const hsp::BallSet &balls = plain.set();
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < n; ++i) all.push_back(i);
    const hsp::Span<const uint32_t> tied(all.data(), n);
    const PointKind expected = kind_by_cones(set.way);
    // Any set that has the point, by either root.
    bool found = false;
    for (uint32_t i = 0; i < n && !found; ++i) {
      for (uint32_t j = i + 1; j < n && !found; ++j) {
        for (uint32_t k = j + 1; k < n && !found; ++k) {
          if (hsp::are_collinear(balls, i, j, k)) continue;
          for (uint32_t l = k + 1; l <= n && !found; ++l) {
            for (const bool rising : {false, true}) {
              TangentPoint point(lines);
              if (!point.find(balls, {i, j, k}, l == n ? no_id : l, rising)) continue;
              const hsp::Vec3 at = point.place_estimate();
              if (point.place_error() > 1e-3 || std::fabs(at.x - static_cast<double>(set.point[0])) > 0.1 ||
                  std::fabs(at.y - static_cast<double>(set.point[1])) > 0.1 ||
                  std::fabs(at.z - static_cast<double>(set.point[2])) > 0.1) {
                continue;
              }
              found = true;
              const PointKind kind = hsp::kind_of(balls, point, tied, room);
              ASSERT_EQ(kind, expected) << oracle::to_text(set.balls);
              ++kinds[static_cast<int>(kind)];
              if (kind == PointKind::passing) continue;
              uint32_t name[4] = {no_id, no_id, no_id, no_id};
              hsp::name_of(balls, point, tied, kind, room, name);
              // It names the point: that root of its balls with W' < 0.
              TangentPoint named(lines);
              ASSERT_TRUE(named.find(balls, {name[0], name[1], name[2]}, name[3], false));
              ASSERT_EQ(named.compare_levels(point), 0);
              for (uint32_t m = 0; m < n; ++m) ASSERT_EQ(named.nearness(m), 0);
              ASSERT_EQ(name[3] == no_id, kind == PointKind::gate);
              octahedra += n == 6 && kind == PointKind::maximum ? 1 : 0;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(kinds[0], 300);
  EXPECT_GT(kinds[1], 100);
  EXPECT_GT(kinds[2], 300);
  EXPECT_GT(octahedra, 10);
}

// Six balls around a point, no four of which have it strictly inside.
TEST(TiedBalls, AnOctahedronIsAMaximum) {
  const PlainBallSet plain(
      {{-100, 0, 0, 10}, {0, -100, 0, 10}, {0, 0, -100, 10}, {0, 0, 100, 10}, {0, 100, 0, 10}, {100, 0, 0, 10}});
  const hsp::BallSet &balls = plain.set();
  TangentPoint point(lines);
  ASSERT_TRUE(point.find(balls, {0, 1, 2}, 5, false));
  const uint32_t all[6] = {0, 1, 2, 3, 4, 5};
  for (const uint32_t ball : all) EXPECT_EQ(point.nearness(ball), 0);
  EXPECT_EQ(hsp::kind_of(balls, point, {all, 6}, room), PointKind::maximum);
  // Without one of them it is none, and neither a gate.
  EXPECT_EQ(hsp::kind_of(balls, point, {all, 5}, room), PointKind::passing);
  const uint32_t square[4] = {0, 1, 4, 5};
  EXPECT_EQ(hsp::kind_of(balls, point, {square, 4}, room), PointKind::gate);
  uint32_t name[4];
  hsp::name_of(balls, point, {square, 4}, PointKind::gate, room, name);
  EXPECT_EQ(name[0], 0U);
  EXPECT_EQ(name[1], 1U);
  EXPECT_EQ(name[2], 4U);
  EXPECT_EQ(name[3], no_id);
  const uint32_t three[3] = {0, 1, 5};
  EXPECT_EQ(hsp::kind_of(balls, point, {three, 3}, room), PointKind::passing);
}

TEST(TiedBalls, CornersAndSidesBelongToSimplices) {
  // The point is the middle of 0 and 5, and of 1 and 4.
  const PlainBallSet plain(
      {{-100, 0, 0, 10}, {0, -100, 0, 10}, {0, 0, -100, 10}, {0, 0, 100, 10}, {0, 100, 0, 10}, {100, 0, 0, 10}});
  TangentPoint point(lines);
  ASSERT_TRUE(point.find(plain.set(), {0, 1, 2}, 5, false));
  bool on_side = false;
  EXPECT_TRUE(hsp::is_in_triangle(plain.set(), point, 0, 1, 5, on_side));
  EXPECT_TRUE(on_side);
  const uint32_t around[4] = {0, 1, 2, 5}, beside[4] = {0, 1, 2, 3};
  EXPECT_TRUE(hsp::is_in_tetrahedron(plain.set(), point, around, on_side));
  EXPECT_TRUE(on_side);
  EXPECT_TRUE(hsp::is_in_tetrahedron(plain.set(), point, beside, on_side));
  EXPECT_TRUE(on_side);
}

}  // namespace
