// Questions about the actual set, held against their definitions in long doubles wherever these are far from undecided;
// and where balls tie in every way, against themselves: the same wherever the set stands, one way or the other, never
// undecided where creases ask (creases_test.cpp).
#include "surface/actual_balls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "built_surface.hpp"
#include "long_reals.hpp"
#include "random_numbers.hpp"
#include "surface/actual_decisions.hpp"
#include "surface/covered_gaps.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::BorderPoint;
using Real = long double;

struct Point {
  Real x, y, z;
};
Point operator+(const Point &a, const Point &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Point operator-(const Point &a, const Point &b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point operator*(Real s, const Point &a) {
  return {s * a.x, s * a.y, s * a.z};
}
Real dot(const Point &a, const Point &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point cross(const Point &a, const Point &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real length(const Point &a) {
  return std::sqrt(dot(a, a));
}
Point rotated(const Point &x, const Point &about, const Point &axis, Real angle) {
  const Point e = 1 / length(axis) * axis, d = x - about;
  return about + std::cos(angle) * d + std::sin(angle) * cross(e, d) + (1 - std::cos(angle)) * dot(e, d) * e;
}

constexpr Real sure = 1e-7L;
int sign(Real x) {
  return x > sure ? 1 : x < -sure ? -1 : 0;
}

// By trilateration in a frame of the three centres. Height: the square of what is left for the third coordinate.
struct Meeting {
  Real height = -1;
  Point at[2] = {};  // below and above the plane, seen from where the centres are counter-clockwise
};
Meeting meeting(const Point &a, Real ra, const Point &b, Real rb, const Point &c, Real rc) {
  const Point ex = 1 / length(b - a) * (b - a);
  const Real i = dot(ex, c - a), d = length(b - a);
  const Point rest = c - a - i * ex, ey = 1 / length(rest) * rest, ez = cross(ex, ey);
  const Real j = dot(ey, c - a);
  const Real x = (ra * ra - rb * rb + d * d) / (2 * d), y = (ra * ra - rc * rc + i * i + j * j - 2 * i * x) / (2 * j);
  Meeting result;
  result.height = ra * ra - x * x - y * y;
  const Real z = result.height > 0 ? std::sqrt(result.height) : 0;
  result.at[0] = a + x * ex + y * ey - z * ez;
  result.at[1] = a + x * ex + y * ey + z * ez;
  return result;
}

// In units of the probe.
class Definitions {
 public:
  explicit Definitions(const BuiltSurface &built) : built_(built) {}

  Real radius(uint32_t i) const { return static_cast<Real>(balls().r[i]) / probe(); }
  Point centre(uint32_t i) const {
    const hsp::Vec3 v = balls().difference(0, i);
    return {static_cast<Real>(v.x) / probe(), static_cast<Real>(v.y) / probe(), static_cast<Real>(v.z) / probe()};
  }
  Point vertex(uint32_t v) const {
    const hsp::VertexRecord &record = boundary().vertex(v);
    return meeting(centre(record.ball[0]), radius(record.ball[0]), centre(record.ball[1]), radius(record.ball[1]),
                   centre(record.ball[2]), radius(record.ball[2]))
        .at[record.positive() ? 1 : 0];
  }
  // Of the circle of two balls, the point on its axis at the probe's radius from all of it.
  Point cusp(uint32_t a, uint32_t b, bool second) const {
    const Point u = centre(b) - centre(a);
    const Real d = length(u), h = (d * d + radius(a) * radius(a) - radius(b) * radius(b)) / (2 * d);
    const Real rho = radius(a) * radius(a) - h * h;
    return centre(a) + (h + (second ? 1 : -1) * std::sqrt(1 - rho)) / d * u;
  }
  // On which side of the plane through a vertex and two of its balls the third one and a point are: 1 if the same.
  int inside(const Point &x, uint32_t v, uint32_t slot) const {
    const hsp::VertexRecord &record = boundary().vertex(v);
    const Point here = vertex(v);
    const Point n = cross(centre(record.ball[(slot + 1) % 3]) - here, centre(record.ball[(slot + 2) % 3]) - here);
    return sign(dot(n, x - here)) * sign(dot(n, centre(record.ball[slot]) - here));
  }

 private:
  const hsp::BallSet &balls() const { return built_.balls(); }
  const hsp::Boundary &boundary() const { return built_.boundary(); }
  Real probe() const { return static_cast<Real>(balls().probe_steps); }

  const BuiltSurface &built_;
};

void expect_sign(int ours, int expected) {
  if (expected != 0) {
    EXPECT_EQ(ours, expected);
  }
}

// 1 if the point is in the patch of a vertex, -1 if it certainly is not.
int in_patch(const Definitions &real, const Point &x, uint32_t v) {
  int inside = 1;
  for (uint32_t slot = 0; slot < 3; ++slot) inside = std::min(inside, real.inside(x, v, slot));
  return inside;
}

// How deep points of the patch of one vertex are in the probe at another one, at most, as far as so many points tell.
Real deepest_in_probe(const Definitions &real, const hsp::Boundary &boundary, uint32_t v, uint32_t other) {
  constexpr int parts = 60;
  const Point here = real.vertex(v), there = real.vertex(other);
  Point corner[3];
  for (uint32_t slot = 0; slot < 3; ++slot) {
    const Point arm = real.centre(boundary.vertex(v).ball[slot]) - here;
    corner[slot] = 1 / length(arm) * arm;
  }
  Real most = -2;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; i + j <= parts; ++j) {
      const Point mean = static_cast<Real>(i) * corner[0] + static_cast<Real>(j) * corner[1] +
                         static_cast<Real>(parts - i - j) * corner[2];
      most = std::max(most, 1 - length(here + 1 / length(mean) * mean - there));
    }
  }
  return most;
}

int in_patch(const hsp::ActualBalls &actual, const BorderPoint &point, uint32_t v) {
  return actual.decide_at(v, [&](const auto &points) {
    auto arm = hsp::vector_of(points);
    points.find_arm(v, point, arm);
    return points.inside_of_sides(v, arm);
  });
}

// Which points of three vertices are corners, and of their creases what a small way along them shows.
void ask_about_corners(const Definitions &real, const hsp::ActualBalls &actual, uint32_t a, uint32_t b, uint32_t c,
                       const std::vector<uint32_t> &near, uint64_t &corners) {
  const Point p[3] = {real.vertex(a), real.vertex(b), real.vertex(c)};
  const Meeting meet = meeting(p[0], 1, p[1], 1, p[2], 1);
  const uint32_t found = actual.corners(a, b, c, {near.data(), static_cast<uint32_t>(near.size())});
  if (sign(meet.height) < 0) {
    EXPECT_EQ(found, 0U);
  }
  if (sign(meet.height) <= 0) return;
  const BorderPoint names[2] = {{BorderPoint::Kind::corner, -1, {a, b, c}}, {BorderPoint::Kind::corner, 1, {a, b, c}}};
  for (int k = 0; k < 2; ++k) {
    const Point x = meet.at[k];
    ++corners;
    expect_sign(in_patch(actual, names[k], b), in_patch(real, x, b));
    int expected = in_patch(real, x, a);
    for (const uint32_t other : near) {
      if (other != b && other != c) expected = std::min(expected, sign(length(x - real.vertex(other)) - 1));
    }
    expect_sign((found >> k & 1) != 0 ? 1 : -1, expected);
    // Along each of the three creases.
    for (int third = 0; third < 3; ++third) {
      const int from = third == 0 ? 1 : 0, to = third == 2 ? 1 : 2;
      const Point after = rotated(x, p[from], p[to] - p[from], 1e-4L);
      const uint32_t id[3] = {a, b, c};
      expect_sign(hsp::ActualBalls::starts_at_corner(names[k], id[from], id[to]) ? 1 : -1,
                  sign(length(after - p[third]) - 1));
    }
  }
  const Point axis = p[1] - p[0];
  const int turn = sign(dot(axis, cross(meet.at[0] - p[0], meet.at[1] - p[0])));
  expect_sign(actual.turn(a, b, names[0], names[1]), turn);
  expect_sign(actual.turn(a, b, names[1], names[0]), -turn);
}

std::vector<uint32_t> others_below(uint32_t n, uint32_t a) {
  std::vector<uint32_t> others;
  for (uint32_t k = 0; k < n; ++k) {
    if (k != a) others.push_back(k);
  }
  return others;
}

support::BallList random_list(support::Random &random, uint32_t n, double side) {
  support::BallList list;
  const auto below = [&random](double x) { return std::floor(x * random.fraction() * 0x1p24) * 0x1p-24; };
  for (uint32_t i = 0; i < n; ++i) {
    const double x = below(side), y = below(side), z = below(side);
    list.add(x, y, z, random.below(4) == 0 ? 0.0 : below(1.0));
  }
  return list;
}

TEST(ActualBalls, DefinitionsInRandomSets) {
  if (!oracle::has_long_reals) GTEST_SKIP();
  support::Random random(71);
  uint64_t corners = 0, cusps = 0, pairs = 0, patches[2] = {0, 0};
  for (int turn = 0; turn < oracle::rounds(60, 3000) && !testing::Test::HasFailure(); ++turn) {
    const BuiltSurface built(random_list(random, 4 + random.below(6), 2.0), 0.5 + 0.25 * random.below(6), 0x1p-24);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const Definitions real(built);
    const hsp::ActualBalls actual(built.balls(), built.boundary());
    const hsp::Boundary &boundary = built.boundary();
    const uint32_t n = std::min(boundary.vertex_count(), 8U);
    for (uint32_t a = 0; a < n; ++a) {
      const std::vector<uint32_t> near = others_below(n, a);
      if (boundary.component(boundary.vertex(a).ball[0]) != boundary.component(boundary.vertex(0).ball[0])) continue;
      for (uint32_t b = a + 1; b < n; ++b) {
        expect_sign(actual.overlap(a, b), sign(2 - length(real.vertex(b) - real.vertex(a))));
        ++pairs;
        for (const auto &[v, other] : {std::pair(a, b), std::pair(b, a)}) {
          const Real deepest = deepest_in_probe(real, boundary, v, other);
          if (std::fabs(deepest) > 0.05L) {
            ++patches[deepest > 0 ? 1 : 0];
            EXPECT_EQ(actual.may_cut_patch(other, v), deepest > 0);
          }
        }
        for (uint32_t c = b + 1; c < n; ++c) ask_about_corners(real, actual, a, b, c, near, corners);
      }
    }
    const hsp::CuspedCircles &cusped = built.surface().cusped_circles();
    for (uint32_t i = 0; i < built.balls().n; ++i) {
      for (const uint32_t e : boundary.half_edges(i)) {
        const uint32_t j = boundary.half_edge(e).circle;
        const uint32_t k = cusped.of_arc(std::min(i, j), std::max(i, j));
        EXPECT_EQ(actual.has_cusps(i, j), k != hsp::no_id);
        if (k == hsp::no_id) continue;
        const uint32_t v = boundary.half_edge(e).vertex;
        const uint32_t w = vertex_across_gap(built.balls(), boundary, built.surface().chosen(), i, e);
        const hsp::VertexRecord &record = boundary.vertex(v);
        uint32_t third = 0;
        while (record.ball[third] == i || record.ball[third] == j) ++third;
        for (int side = 0; side < 2; ++side) {
          const uint32_t low = std::min(i, j), high = std::max(i, j);
          const Point x = real.cusp(low, high, side == 1);
          const Point after = rotated(x, real.vertex(v), real.vertex(w) - real.vertex(v), 1e-4L);
          expect_sign(actual.starts_at_cusp(
                          {BorderPoint::Kind::cusp, static_cast<int8_t>(side == 1 ? 1 : -1), {low, high, 0}}, v, w),
                      real.inside(after, v, third));
          ++cusps;
        }
      }
    }
  }
  EXPECT_GT(corners, 300U);
  EXPECT_GT(cusps, 50U);
  EXPECT_GT(pairs, 1000U);
  EXPECT_GT(patches[0], 500U);
  EXPECT_GT(patches[1], 50U);
}

bool on_one_circle(const hsp::Boundary &boundary, uint32_t a, uint32_t b, uint32_t c) {
  int common = 0;
  for (const uint32_t ball : boundary.vertex(a).ball) {
    common += boundary.vertex(b).has(ball) && boundary.vertex(c).has(ball) ? 1 : 0;
  }
  return common >= 2;
}

// All answers about a set as a string of signs.
std::string all_answers(const BuiltSurface &built, const hsp::ActualBalls &actual) {
  std::string signs;
  const auto add = [&signs](int sign) { signs += sign > 0 ? '+' : sign < 0 ? '-' : '0'; };
  const uint32_t n = std::min(built.boundary().vertex_count(), 7U);
  for (uint32_t a = 0; a < n; ++a) {
    const std::vector<uint32_t> near = others_below(n, a);
    for (uint32_t b = a + 1; b < n; ++b) {
      add(actual.overlap(a, b));
      add(actual.may_cut_patch(a, b) ? 1 : -1);
      add(actual.may_cut_patch(b, a) ? 1 : -1);
      for (uint32_t c = b + 1; c < n; ++c) {
        // The corner of three vertices of one circle would be on its axis, where three bisectors meet.
        if (on_one_circle(built.boundary(), a, b, c)) continue;
        const uint32_t found = actual.corners(a, b, c, {near.data(), n - 1});
        for (const int8_t side : {int8_t{-1}, int8_t{1}}) {
          const BorderPoint corner{BorderPoint::Kind::corner, side, {a, b, c}};
          const bool there = (found & (side < 0 ? 1U : 2U)) != 0;
          add(there ? 1 : -1);
          if (!there) continue;
          // One patch answers for three.
          EXPECT_EQ(in_patch(actual, corner, b), 1);
          EXPECT_EQ(in_patch(actual, corner, c), 1);
          for (const uint32_t v : {a, b, c}) {
            for (const uint32_t other : {a, b, c}) EXPECT_TRUE(v == other || actual.may_cut_patch(other, v));
          }
        }
      }
    }
  }
  return signs;
}

// Points on a lattice: all probes around one meet in it, and nothing but what moves the actual balls decides.
TEST(ActualBalls, TiesAreDecidedAlikeWhereverTheSetStands) {
  support::Random random(72);
  hsp::ActualBalls::Answers answers;
  for (int turn = 0; turn < oracle::rounds(10, 400) && !testing::Test::HasFailure(); ++turn) {
    support::BallList list, moved;
    const int64_t far = INT64_C(1) << random.below(20);
    for (uint32_t i = 0; i < 5; ++i) {
      const double x = random.below(3), y = random.below(3), z = random.below(3);
      list.add(x, y, z, 0.0);
      moved.add(x + static_cast<double>(far), y - 3 * static_cast<double>(far), z + 7, 0.0);
    }
    const double probe = random.below(2) == 0 ? 1.0 : 2.0;
    const BuiltSurface built(list, probe, 0x1p-20), other(moved, probe, 0x1p-20);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::ActualBalls actual(built.balls(), built.boundary()), elsewhere(other.balls(), other.boundary());
    if (built.boundary().vertex_count() != other.boundary().vertex_count()) continue;
    bool same = true;
    for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
      for (int k = 0; k < 3; ++k) {
        same = same && built.balls().caller[built.boundary().vertex(v).ball[k]] ==
                           other.balls().caller[other.boundary().vertex(v).ball[k]];
      }
    }
    // The grid's cubes may put balls into another order.
    if (!same) continue;
    const std::string signs = all_answers(built, actual);
    EXPECT_EQ(signs, all_answers(other, elsewhere));
    answers.by_doubles += actual.answers().by_doubles;
    answers.by_floats += actual.answers().by_floats;
  }
  EXPECT_GT(answers.by_doubles, 20U);
  EXPECT_GT(answers.by_floats, 10U);
}

}  // namespace
