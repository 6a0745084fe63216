// Kinds of points where balls tie, held against cones in integers: directions span space, or a plane, if and only if
// the opposite of each is in the cone that all make up.
#include "pores/tied_balls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pore_sets.hpp"
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
hsp::Vec3 vectors[160];
const hsp::Span<hsp::Vec3> room(vectors, 160);

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
              const hsp::Vec3 at = point.position_estimate();
              if (point.position_error() > 1e-3 || std::fabs(at.x - static_cast<double>(set.point[0])) > 0.1 ||
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

// Whether 0 is in the triangle of three centres in the plane z = 0, or in the tetrahedron of four, none of them flat.
bool is_around_zero(const std::vector<Vector> &corners) {
  const bool flat = corners.size() == 3;
  const Vector up{0, 0, 1};
  const Int128 all = flat ? dot(cross(corners[0], corners[1]), up) + dot(cross(corners[1], corners[2]), up) +
                                dot(cross(corners[2], corners[0]), up)
                          : volume(corners[1], corners[2], corners[3]) - volume(corners[0], corners[2], corners[3]) +
                                volume(corners[0], corners[1], corners[3]) - volume(corners[0], corners[1], corners[2]);
  if (all == 0) return false;
  for (size_t k = 0; k < corners.size(); ++k) {
    std::vector<Vector> replaced = corners;
    replaced[k] = {0, 0, 0};
    const Int128 part =
        flat ? dot(cross(replaced[0], replaced[1]), up) + dot(cross(replaced[1], replaced[2]), up) +
                   dot(cross(replaced[2], replaced[0]), up)
             : volume(replaced[1], replaced[2], replaced[3]) - volume(replaced[0], replaced[2], replaced[3]) +
                   volume(replaced[0], replaced[1], replaced[3]) - volume(replaced[0], replaced[1], replaced[2]);
    if (oracle::sign_of(part) * oracle::sign_of(all) < 0) return false;
  }
  return true;
}

// The first set of so many, in the order of the balls, that is around 0.
std::vector<uint32_t> first_around_zero(const std::vector<Vector> &way, uint32_t size) {
  const auto n = static_cast<uint32_t>(way.size());
  for (uint32_t a = 0; a < n; ++a) {
    for (uint32_t b = a + 1; b < n; ++b) {
      for (uint32_t c = b + 1; c < n; ++c) {
        if (size == 3 && is_around_zero({way[a], way[b], way[c]})) return {a, b, c};
        for (uint32_t d = c + 1; size == 4 && d < n; ++d) {
          if (is_around_zero({way[a], way[b], way[c], way[d]})) return {a, b, c, d};
        }
      }
    }
  }
  return {};
}

// Balls on a circle, or a part of it, and some on its axis: what is asked of the exact stage is some questions a ball.
TEST(TiedBalls, ManyInOnePlane) {
  oracle::RandomSource random(2);
  int kinds[3] = {0, 0, 0};
  for (int turn = 0; turn < 36; ++turn) {
    oracle::Balls all = pore_sets::exact_circle(turn < 24 ? 25 : 65, 1000, 100, turn % 3), chosen;
    for (size_t k = all.size(); k > 1; --k) {
      std::swap(all[k - 1], all[static_cast<size_t>(random.in(0, static_cast<int64_t>(k) - 1))]);
    }
    for (const auto &ball : all) {
      if (turn / 3 % 4 == 1 && ball.y < 0) continue;                       // half of it, with its ends
      if (turn / 3 % 4 == 2 && ball.y < 0 && !random.one_in(4)) continue;  // few of the other half
      if (turn / 3 % 4 == 3 && ball.y <= 0 && ball.z == 0) continue;       // without its ends
      chosen.push_back(ball);
    }
    std::vector<Vector> way;
    std::vector<uint32_t> tied, circle;
    for (const auto &ball : chosen) {
      if (ball.z == 0) circle.push_back(static_cast<uint32_t>(tied.size()));
      tied.push_back(static_cast<uint32_t>(tied.size()));
      way.push_back({-ball.x, -ball.y, -ball.z});
    }
    if (circle.size() < 3 || tied.size() < 4) continue;
    const PlainBallSet plain(chosen);
    const auto n = static_cast<uint32_t>(tied.size());
    hsp::TangentLines own;
    TangentPoint point(own);
    ASSERT_TRUE(point.find(plain.set(), {circle[0], circle[1], circle[2]}, no_id, false));
    const PointKind expected = kind_by_cones(way), kind = hsp::kind_of(plain.set(), point, {tied.data(), n}, room);
    ASSERT_EQ(kind, expected) << oracle::to_text(chosen);
    ++kinds[static_cast<int>(kind)];
    if (kind != PointKind::passing) {
      uint32_t name[4] = {no_id, no_id, no_id, no_id};
      hsp::name_of(plain.set(), point, {tied.data(), n}, kind, room, name);
      const uint32_t size = kind == PointKind::gate ? 3 : 4;
      ASSERT_EQ(std::vector<uint32_t>(name, name + size), first_around_zero(way, size)) << oracle::to_text(chosen);
    }
    EXPECT_LT(own.questions(), 40 + 12 * n) << oracle::to_text(chosen);
    hsp::TiedDirections directions(plain.set(), point, {tied.data(), n}, room);
    for (int question = 0; question < 200; ++question) {
      uint32_t ball[3];
      for (uint32_t &each : ball) each = static_cast<uint32_t>(random.in(0, n - 1));
      if (ball[0] == ball[1] || ball[1] == ball[2] || ball[2] == ball[0]) continue;
      ASSERT_EQ(directions.side_of_plane(ball[0], ball[1], ball[2]), point.side_of_plane(ball[0], ball[1], ball[2]));
    }
  }
  for (const int count : kinds) EXPECT_GT(count, 3);
}

// Of equal balls on a circle that all tie a step above its plane or below, nearer than doubles see it.
TEST(TiedBalls, SidesOfAPlaneThatIsNearTheirPoint) {
  for (const int64_t up : {1, -1, 4, 0}) {
    oracle::Balls balls = pore_sets::exact_circle(65, 100000000, 100, 0);
    const auto n = static_cast<uint32_t>(balls.size());
    balls.push_back({0, 0, 6500000000 + up, 100});
    const PlainBallSet plain(balls);
    std::vector<uint32_t> all;
    for (uint32_t k = 0; k <= n; ++k) all.push_back(k);
    hsp::TangentLines own;
    TangentPoint point(own);
    ASSERT_TRUE(point.find(plain.set(), {0, 11, 23}, n, false));
    ASSERT_EQ(point.side_of_plane(0, 11, 23) != 0, up != 0);
    hsp::TiedDirections directions(plain.set(), point, {all.data(), n + 1}, room);
    uint64_t asked = 0;
    for (uint32_t i = 0; i < n; i += 2) {
      for (uint32_t j = i + 1; j < n; j += 3) {
        for (uint32_t k = j + 1; k < n; k += 2) {
          const uint64_t before = own.questions();
          const int side = directions.side_of_plane(i, j, k);
          asked += own.questions() - before;
          ASSERT_EQ(side, point.side_of_plane(i, j, k)) << up;
        }
      }
    }
    EXPECT_LT(asked, 2 * n);
    EXPECT_EQ(hsp::kind_of(plain.set(), point, {all.data(), n + 1}, room),
              up > 0 ? PointKind::maximum : PointKind::passing);
  }
}

TEST(TiedBalls, DepthInACircle) {
  oracle::RandomSource random(3);
  int inside = 0;
  for (int turn = 0; turn < 300; ++turn) {
    const auto count = static_cast<uint32_t>(random.in(3, 40));
    const double width = turn % 3 == 0 ? 6.2831853 : 3.0 + 0.01 * static_cast<double>(random.in(0, 60));
    std::vector<double> angles;
    std::vector<hsp::Vec3> a;
    for (uint32_t k = 0; k < count; ++k) {
      angles.push_back(width * static_cast<double>(random.in(0, 1000000)) / 1e6);
      a.push_back({std::cos(angles[k]), std::sin(angles[k]), 0.0});
    }
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 6.283185307179586 - angles.back();
    for (uint32_t k = 1; k < count; ++k) gap = std::max(gap, angles[k] - angles[k - 1]);
    a.push_back({0.0, 0.0, 1.0});  // is not in the plane
    uint32_t three[3];
    const double depth = hsp::depth_in_circle({a.data(), count + 1}, {0.0, 0.0, 1.0}, 1e-9, three);
    const double expected = gap < 3.141592653589793 ? std::cos(0.5 * gap) : 0.0;
    ASSERT_LE(depth, expected + 1e-9);
    if (!(expected > 1e-5)) continue;
    ++inside;
    ASSERT_GT(depth, std::min(expected, 0.98) - 1e-5);
    for (uint32_t k = 0; k < 3; ++k) {
      const hsp::Vec3 &p = a[three[k]], &q = a[three[(k + 1) % 3]];
      ASSERT_GE(p.x * q.y - p.y * q.x, -1e-12);
    }
  }
  EXPECT_GT(inside, 50);
}

// Some unit vectors beside a direction and some elsewhere, all on one side of 0, or six more around it. Doubles do not
// know the planes of those that are close together.
TEST(TiedBalls, DepthOfVectorsThatAreCloseTogether) {
  oracle::RandomSource random(4);
  const auto any = [&] { return static_cast<double>(random.in(-1000000, 1000000)) / 1e6; };
  int inside = 0;
  for (int turn = 0; turn < 3000; ++turn) {
    const auto count = static_cast<uint32_t>(random.in(4, 12));
    const auto close = static_cast<uint32_t>(random.in(2, 4));
    const double apart = std::pow(10.0, -static_cast<double>(random.in(1, 14)) / 2.0 - 2.0);
    const hsp::Vec3 corners[6] = {{1.0, 0.0, 0.0},  {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                  {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0},  {0.0, 0.0, -1.0}};
    const bool around = turn % 4 == 3;
    std::vector<hsp::Vec3> a;
    const hsp::Vec3 middle{any(), any(), 1.0};
    for (uint32_t k = 0; k < count; ++k) {
      hsp::Vec3 v{any(), any(), 0.01};
      if (k < close) v = middle + apart * hsp::Vec3{any(), any(), any()};
      a.push_back((1.0 / std::sqrt(dot(v, v))) * v);
    }
    for (uint32_t k = 0; around && k < 6; ++k) a.insert(a.begin() + k, corners[k]);
    const double depth = hsp::depth_of_hull({a.data(), static_cast<uint32_t>(a.size())});
    if (!around) {
      ASSERT_LE(depth, 0.0) << turn;
    } else {
      inside += depth > 0.5 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 500);
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
