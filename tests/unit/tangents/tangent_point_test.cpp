// Points at equal distances, held against sets that tie at a lattice point by construction, where every sign is one of
// small integers; and one step beside them.
#include "tangents/tangent_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tied_sets.hpp"

namespace {

using hsp::no_id;
using hsp::TangentCurve;
using hsp::TangentPoint;
using oracle::cross;
using oracle::dot;
using oracle::Int128;

hsp::TangentLines lines;

oracle::Vector minus(const oracle::Vector &a, const oracle::Vector &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Int128 volume(const oracle::Vector &a, const oracle::Vector &b, const oracle::Vector &c) {
  return dot(cross(a, b), c);
}

// The root that is the given point, if one of them is.
bool at_point(const hsp::BallSet &balls, const TiedSet &set, const TangentCurve &curve, uint32_t last,
              TangentPoint &found) {
  for (const bool rising : {false, true}) {
    TangentPoint point(lines);
    if (!point.find(balls, curve, last, rising)) continue;
    hsp::Vec3 place{};
    double level = 0.0;
    point.refine(place, level);
    const double off =
        std::hypot(place.x - static_cast<double>(set.point[0]), place.y - static_cast<double>(set.point[1]),
                   place.z - static_cast<double>(set.point[2]));
    if (off > 1e-4 || std::fabs(level - static_cast<double>(set.level)) > 1e-4) continue;
    found = point;
    return true;
  }
  return false;
}

struct Seen {
  int points = 0, flat = 0, in_plane = 0;
};

void check_signs(const hsp::BallSet &balls, const TiedSet &set, const TangentPoint &point) {
  const uint32_t n = balls.n;
  for (uint32_t i = 0; i < n; ++i) ASSERT_EQ(point.nearness(i), 0);
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < n; ++j) {
      const uint32_t k = (i + j + 1) % n;
      if (i == j || i == k || j == k) continue;
      // n.(x - c_i) with n = (c_j - c_i) x (c_k - c_i), where c = x - way.
      const oracle::Vector &w = set.way[i];
      const oracle::Vector normal = cross(minus(w, set.way[j]), minus(w, set.way[k]));
      ASSERT_EQ(point.side_of_plane(i, j, k), oracle::sign_of(dot(normal, w)));
      if (dot(normal, w) == 0 && !oracle::is_zero(normal)) {
        ASSERT_EQ(point.side_of_edge({i, j, k}, i, j), oracle::sign_of(dot(normal, cross(minus(w, set.way[j]), w))));
      }
    }
  }
  for (uint32_t axis = 0; axis < 3; ++axis) {
    for (const int step : {-1, 0, 1}) ASSERT_EQ(point.against(axis, set.point[axis] + step), -step);
  }
  for (const int step : {-1, 0, 1}) ASSERT_EQ(point.level_against(set.level + step), -step);
}

// A ball more, one step larger or smaller than one that ties.
void check_beside(const TiedSet &set, const TangentCurve &curve, uint32_t last) {
  TiedSet more = set;
  const auto n = static_cast<uint32_t>(set.balls.size());
  for (const int step : {-1, 1}) {
    more.balls[n - 1].radius = set.balls[n - 1].radius + step;
    if (more.balls[n - 1].radius < 0) continue;
    bool fits = true;
    for (uint32_t i = 0; i + 1 < n; ++i) {
      fits = fits && !lies_inside(more.balls[n - 1], more.balls[i]) && !lies_inside(more.balls[i], more.balls[n - 1]);
    }
    if (!fits) continue;
    const PlainBallSet balls(more.balls);
    TangentPoint point(lines);
    ASSERT_TRUE(at_point(balls.set(), set, curve, last, point));
    ASSERT_EQ(point.nearness(n - 1), -step);
    // As seen from the other ball: the point of the set with it is above or below by less than both.
    TangentPoint other(lines);
    if (!other.find(balls.set(), curve, n - 1, false)) continue;
    const int order = point.compare_levels(other);
    ASSERT_EQ(order, -other.compare_levels(point));
    ASSERT_NE(order, 0);
  }
}

TEST(TangentPoint, SetsThatTieAtALatticePoint) {
  oracle::RandomSource random(1);
  Seen seen;
  for (int turn = 0; turn < 3000; ++turn) {
    const bool flat = random.one_in(4);
    const TiedSet set =
        tied_set(random, static_cast<size_t>(random.in(5, 7)), static_cast<size_t>(random.in(1, 9)), flat);
    if (set.balls.size() < 5) continue;
    const PlainBallSet plain(set.balls);
    const hsp::BallSet &balls = plain.set();
    const oracle::Vector &w = set.way[0];
    const oracle::Vector u = minus(w, set.way[1]), v = minus(w, set.way[2]), z = minus(w, set.way[3]);
    if (oracle::is_zero(cross(u, v))) {
      ASSERT_TRUE(hsp::are_collinear(balls, 0, 1, 2));
      continue;
    }
    ASSERT_FALSE(hsp::are_collinear(balls, 0, 1, 2));
    ASSERT_EQ(hsp::are_coplanar(balls, 0, 1, 2, 3), volume(u, v, z) == 0);
    const TangentCurve curve{0, 1, 2};
    TangentPoint point(lines);
    if (at_point(balls, set, curve, 3, point)) {
      ++seen.points;
      seen.flat += volume(u, v, z) == 0 ? 1 : 0;
      ASSERT_NO_FATAL_FAILURE(check_signs(balls, set, point));
      ASSERT_NO_FATAL_FAILURE(check_beside(set, curve, 3));
      ASSERT_EQ(point.side_of_curve(curve), oracle::sign_of(volume(u, v, w)));
    }
    // Unless the fourth ball touches the curve without crossing it, or stays as near all along it: then the unit
    // vectors from the centres to the point are in one plane.
    const auto length = [&](size_t i) { return Int128{set.balls[i].radius + set.level}; };
    const oracle::Vector &a = set.way[1], &b = set.way[2], &c = set.way[3];
    const Int128 determinant = length(0) * volume(a, b, c) - length(1) * volume(w, b, c) + length(2) * volume(w, a, c) -
                               length(3) * volume(w, a, b);
    ASSERT_EQ(at_point(balls, set, curve, 3, point), determinant != 0);
    if (volume(u, v, w) == 0 && at_point(balls, set, curve, no_id, point)) {
      ++seen.in_plane;
      ASSERT_NO_FATAL_FAILURE(check_signs(balls, set, point));
      ASSERT_NO_FATAL_FAILURE(check_beside(set, curve, no_id));
    }
  }
  EXPECT_GT(seen.points, 1000);
  EXPECT_GT(seen.flat, 10);
  EXPECT_GT(seen.in_plane, 100);
}

// Two sets far from each other, so that the order of their points is that of two integers, or a tie.
TEST(TangentPoint, OrderOfLevels) {
  oracle::RandomSource random(2);
  int ties = 0, orders = 0;
  for (int turn = 0; turn < 2000; ++turn) {
    TiedSet a = tied_set(random, 4, 9, random.one_in(3)), b = tied_set(random, 4, 9, random.one_in(3));
    if (a.balls.size() < 4 || b.balls.size() < 4) continue;
    if (random.one_in(2)) {
      for (auto &ball : b.balls) ball.radius += b.level - a.level;
      b.level = a.level;
    }
    oracle::Balls all = a.balls;
    for (auto &ball : b.balls) {
      ball.x += 20000;
      all.push_back(ball);
    }
    b.point[0] += 20000;
    const PlainBallSet balls(all);
    TangentPoint p(lines), q(lines);
    if (!at_point(balls.set(), a, {0, 1, 2}, 3, p) || !at_point(balls.set(), b, {4, 5, 6}, 7, q)) continue;
    const int expected = a.level < b.level ? -1 : a.level > b.level ? 1 : 0;
    ASSERT_EQ(p.compare_levels(q), expected);
    ASSERT_EQ(q.compare_levels(p), -expected);
    ++(expected == 0 ? ties : orders);
  }
  EXPECT_GT(ties, 100);
  EXPECT_GT(orders, 100);
}

// Three balls with a circle of radius (a^2 + h^2) / 2h through their centres, an odd multiple of half a unit: ties are
// rounded up, whichever ball the point is seen from.
TEST(TangentPoint, LevelsHalfWayBetweenUnitsAreRoundedUp) {
  const int64_t h = INT64_C(1) << 20;
  int below = 0, above = 0;
  for (int64_t a = h / 2 + 1; a < h; a += h / 200 * 2) {
    for (const int64_t radius : {INT64_C(0), 2 * h}) {
      const PlainBallSet balls({{a, 0, 0, radius}, {-a, 0, 0, radius}, {0, h, 0, radius}});
      const int64_t half_units = a * a + h * h - 2 * h * radius;
      ASSERT_NE(half_units % 2, 0);
      for (const TangentCurve &curve : {TangentCurve{0, 1, 2}, TangentCurve{1, 2, 0}, TangentCurve{2, 0, 1}}) {
        TangentPoint point(lines);
        ASSERT_TRUE(point.find(balls.set(), curve, no_id, false));
        hsp::Vec3 place{};
        double level = 0.0;
        point.refine(place, level);
        EXPECT_EQ(level, std::ldexp(static_cast<double>(half_units + 1), -21)) << a << ' ' << radius;
        ++(level < 0.0 ? below : above);
      }
    }
  }
  EXPECT_GT(below, 100);
  EXPECT_GT(above, 100);
}

// Two balls that touch, and a point h steps beside that place: the gate is h^2 / 2 (h + R) from that point. Its place
// is known far better than to a step, though distances from the two balls hardly change there.
TEST(TangentPoint, PlacesBesideWhereTwoBallsTouch) {
  for (const int64_t R : {INT64_C(100000000), INT64_C(1000000000), INT64_C(1) << 30}) {
    for (const int64_t h : {1, 2, 3, 5, 10, 30, 100, 1000}) {
      const PlainBallSet balls({{-R, 0, 0, R}, {R, 0, 0, R}, {0, 0, -h, 0}});
      const auto r = static_cast<double>(R), depth = static_cast<double>(h);
      const double level = depth * depth / (2.0 * (depth + r));
      for (const TangentCurve &curve : {TangentCurve{0, 1, 2}, TangentCurve{1, 2, 0}, TangentCurve{2, 0, 1}}) {
        TangentPoint point(lines);
        ASSERT_TRUE(point.find(balls.set(), curve, no_id, false));
        hsp::Vec3 place{};
        double found = 0.0;
        const double error = point.refine(place, found);
        EXPECT_NEAR(found, level, error);
        EXPECT_NEAR(place.x, 0.0, 1e-5) << R << ' ' << h;
        EXPECT_NEAR(place.y, 0.0, 1e-5) << R << ' ' << h;
        EXPECT_NEAR(place.z, level - depth, 1e-5) << R << ' ' << h;
      }
    }
  }
}

// From a tied point up a curve: a ball gets nearer or farther as it does at a place a little further up, in long
// doubles.
TEST(TangentPoint, DepartureAlongCurves) {
  oracle::RandomSource random(3);
  int checked = 0;
  for (int turn = 0; turn < 3000; ++turn) {
    const TiedSet set = tied_set(random, 5, static_cast<size_t>(random.in(2, 9)), false);
    if (set.balls.size() < 5) continue;
    const PlainBallSet plain(set.balls);
    const hsp::BallSet &balls = plain.set();
    const TangentCurve curve{0, 1, 2};
    TangentPoint point(lines);
    if (hsp::are_collinear(balls, 0, 1, 2) || !at_point(balls, set, curve, 3, point)) continue;
    const int side = point.side_of_curve(curve);
    if (side == 0) continue;
    hsp::CurveShape shape(balls, curve);
    if (side < 0) shape.e = -shape.e;
    const double z0 = 2.0 * (balls.r[0] + static_cast<double>(set.level)), step = 1e-3;
    const auto gap = [&](uint32_t ball, double z) {  // of a ball less that of the base
      const hsp::Vec3 y = shape.p + z * shape.q + shape.height(z) * shape.e;
      const hsp::Vec3 d = 0.5 * y - balls.difference(0, ball);
      return std::sqrt(dot(d, d)) - balls.r[ball] - (0.5 * z - balls.r[0]);
    };
    for (const uint32_t ball : {3U, 4U}) {
      if (!(std::fabs(gap(1, z0 + step)) < 1e-9)) continue;  // beyond the top of the curve
      const double there = gap(ball, z0 + step);
      if (std::fabs(there) < 1e-7) continue;
      ASSERT_EQ(point.departure(curve, side, ball), there > 0.0 ? 1 : -1) << oracle::to_text(set.balls);
      ++checked;
    }
  }
  EXPECT_GT(checked, 1000);
}

// Across the whole lattice: equal balls at the corners of a rectangle, and the last one off it by a step.
TEST(TangentPoint, BallsFarApartAreDecided) {
  for (const int power : {20, 34, 36, 40, 50}) {
    const int64_t far = INT64_C(1) << power, near = far - 12345;
    for (const int64_t off : {-1, 0, 1}) {
      const PlainBallSet balls({{-far, -near, 7, 10},
                                {far, -near, 7, 10},
                                {-far, near, 7, 10},
                                {far - 1, near, 7, 10},
                                {far - 1, near + off, 7, 10},
                                {far, near, 7, 10 - off}});
      TangentPoint centre(lines);
      ASSERT_TRUE(centre.find(balls.set(), {0, 1, 2}, no_id, false));
      EXPECT_EQ(centre.nearness(3), -1) << power;
      EXPECT_EQ(centre.nearness(4), -1) << power;
      EXPECT_EQ(centre.nearness(5), static_cast<int>(off)) << power;
      TangentPoint other(lines);  // that of a rectangle whose height is 2 off larger
      const PlainBallSet wider({{-far, -near - off, 7, 10}, {far, -near - off, 7, 10}, {-far, near + off, 7, 10}});
      ASSERT_TRUE(other.find(wider.set(), {0, 1, 2}, no_id, false));
      EXPECT_EQ(other.compare_levels(centre), static_cast<int>(off)) << power;
    }
  }
}

// The longest integers that there are: centres at the ends of the lattice, that tie, or nearly, or lie in one plane.
// The answers about the two points of four balls are the same, whichever of them is the base.
TEST(TangentPoint, AnswersAcrossTheLatticeDoNotDependOnTheBase) {
  constexpr int64_t end = INT64_C(1) << 50, largest = (1 << 30) - 1;
  oracle::RandomSource random(3);
  int found = 0, flat = 0, tied = 0;
  for (int turn = 0; turn < 4000; ++turn) {
    oracle::Balls set;
    for (uint32_t k = 0; k < 5; ++k) {
      const auto coordinate = [&](bool fixed) {
        if (fixed) return end - 5;
        const int64_t nudge = random.one_in(3) ? random.in(0, 3) : 0;
        return random.one_in(2) ? nudge - end : random.one_in(4) ? nudge : end - nudge;
      };
      set.push_back({coordinate(false), coordinate(false), coordinate(turn % 2 == 0),
                     random.one_in(2)   ? largest
                     : random.one_in(2) ? 0
                                        : largest - random.in(0, 9)});
    }
    const PlainBallSet plain(set);
    const hsp::BallSet &balls = plain.set();
    bool apart = true;  // none is inside another one
    for (uint32_t a = 0; a < 5; ++a) {
      for (uint32_t b = 0; b < a; ++b) apart = apart && hsp::longest_part(balls.difference(a, b)) > 0x1p40;
    }
    if (!apart) continue;
    uint32_t order[4] = {0, 1, 2, 3};
    std::vector<int> first;
    do {
      if (hsp::are_collinear(balls, order[0], order[1], order[2])) continue;
      TangentPoint points[2] = {TangentPoint(lines), TangentPoint(lines)};
      bool there[2];
      TangentPoint::find_both(balls, {order[0], order[1], order[2]}, order[3], points, there);
      std::vector<int> answers;
      for (const int root : {0, 1}) {
        if (!there[root]) continue;
        const int nearness = points[root].nearness(4), turns = points[root].side_of_plane(0, 1, 4);
        answers.push_back(100 * nearness + 10 * turns + points[root].level_against(end / 3));
        tied += nearness == 0 ? 1 : 0;
      }
      std::sort(answers.begin(), answers.end());
      answers.push_back(static_cast<int>(answers.size()));
      if (first.empty()) first = answers;
      ASSERT_EQ(answers, first) << oracle::to_text(set);
      found += answers.size() > 1 ? 1 : 0;
      flat += answers.size() > 1 && hsp::are_coplanar(balls, 0, 1, 2, 3) ? 1 : 0;
    } while (std::next_permutation(order, order + 4));
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(flat, 500);
  EXPECT_GT(tied, 40);
}

}  // namespace
