// Paths through the free space of any set. Every segment is tested against every ball in integers of any size. Whether
// there is a path at all is compared with the regions of the library's topology (hsp::region_of_point, by shells and
// rays): another way to the answer, but no independent oracle.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "big_integer.hpp"
#include "built_paths.hpp"
#include "built_topology.hpp"
#include "molecule_balls.hpp"
#include "named_balls.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "topology/regions.hpp"

namespace checked_paths {

using hsp::exact::Vector;
using oracle::Balls;
using oracle::BigInteger;

// How often each case was met, so that a test can require that it has met enough of each.
struct Seen {
  uint32_t found = 0, certified = 0, apart = 0, covered = 0, bent = 0, of_many = 0;
};

template <class Integer>
Integer wide_dot(const Vector &a, const Vector &b) {
  const auto wide = [](int64_t value) { return Integer(oracle::Int128{value}); };
  return wide(a.x) * wide(b.x) + wide(a.y) * wide(b.y) + wide(a.z) * wide(b.z);
}

inline Vector difference(const Vector &b, const Vector &a) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}

inline bool same(const Vector &a, const Vector &b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

// The squared distance of the nearest point of the segment a + t d is least at t = d.p / d.d, if that is in 0 .. 1.
template <class Integer>
bool misses_in(const oracle::LatticeBall &ball, const Vector &d, const Vector &p, const Vector &q) {
  const Integer w = Integer(oracle::Int128{ball.radius}) * Integer(oracle::Int128{ball.radius});
  const Integer from = wide_dot<Integer>(p, p), to = wide_dot<Integer>(q, q);
  if (oracle::sign_of(from - w) <= 0 || oracle::sign_of(to - w) <= 0) return false;
  const Integer along = wide_dot<Integer>(d, p), length = wide_dot<Integer>(d, d);
  if (oracle::sign_of(along) <= 0 || oracle::sign_of(along - length) >= 0) return true;
  return oracle::sign_of(from * length - along * along - w * length) > 0;
}

inline bool misses(const oracle::LatticeBall &ball, const Vector &a, const Vector &b) {
  const Vector centre{ball.x, ball.y, ball.z};
  const Vector d = difference(b, a), p = difference(centre, a), q = difference(centre, b);
  // Boxes first: most balls are far away.
  const auto apart = [&](int64_t s, int64_t t, int64_t c) {
    return std::max(s, t) < c - ball.radius || std::min(s, t) > c + ball.radius;
  };
  if (apart(a.x, b.x, centre.x) || apart(a.y, b.y, centre.y) || apart(a.z, b.z, centre.z)) return true;
  int64_t largest = ball.radius;
  for (const Vector &v : {d, p, q}) largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest < INT64_C(1) << 29) return misses_in<oracle::Int128>(ball, d, p, q);
  return misses_in<BigInteger>(ball, d, p, q);
}

inline bool is_free(const Balls &balls, const Vector &a, const Vector &b) {
  return std::all_of(balls.begin(), balls.end(), [&](const auto &ball) { return misses(ball, a, b); });
}

inline double length_of(const Vector &d) {
  return std::hypot(static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.z));
}

// The distance of a segment from a ball, by ternary search: the distance from the centre is convex along the segment.
inline double clearance(const oracle::LatticeBall &ball, const Vector &a, const Vector &b) {
  const Vector d = difference(b, a), p = difference({ball.x, ball.y, ball.z}, a);
  const auto at = [&](double t) {
    return std::hypot(static_cast<double>(p.x) - t * static_cast<double>(d.x),
                      static_cast<double>(p.y) - t * static_cast<double>(d.y),
                      static_cast<double>(p.z) - t * static_cast<double>(d.z));
  };
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 100; ++k) {
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    (at(first) < at(second) ? high : low) = at(first) < at(second) ? second : first;
  }
  return std::min({at(low), at(0.0), at(1.0)}) - static_cast<double>(ball.radius);
}

inline void check_path(const Balls &balls, const hsp::PathFinder &finder, const hsp::PathSummary &summary,
                       const Vector &from, const Vector &to, bool with_clearance, Seen &seen) {
  const auto points = finder.points();
  ASSERT_GE(points.size(), 2U);
  ASSERT_LE(points.size(), std::max(2U, finder.needed_points()));
  ASSERT_TRUE(same(points[0], from));
  ASSERT_TRUE(same(points[points.size() - 1], to));
  bool all_free = true;
  double length = 0.0, least = INFINITY;
  for (uint32_t k = 1; k < points.size(); ++k) {
    all_free = all_free && is_free(balls, points[k - 1], points[k]);
    length += length_of(difference(points[k], points[k - 1]));
    if (!with_clearance) continue;
    for (const auto &ball : balls) least = std::min(least, clearance(ball, points[k - 1], points[k]));
  }
  ASSERT_EQ(all_free, summary.certified);
  ASSERT_NEAR(summary.length, length, 1e-9 * length);
  if (with_clearance && balls.empty()) {
    ASSERT_EQ(summary.clearance, INFINITY);
  } else if (with_clearance) {
    ASSERT_NEAR(summary.clearance, least, 1e-6 * (1.0 + length + std::fabs(least)));
  }
  ++seen.found;
  seen.certified += summary.certified ? 1U : 0U;
  seen.bent += points.size() > 2 ? 1U : 0U;
  seen.of_many += points.size() > 4 ? 1U : 0U;
}

// Checks paths between random pairs of points. Points are free if one of 40 draws is; a few that are not are tried too.
inline void check(const Balls &balls, oracle::RandomSource &random, int pairs, Seen &seen,
                  const Vector *first = nullptr) {
  BuiltTopology topology(balls);
  ASSERT_EQ(topology.status(), hsp::Status::ok);
  BuiltPaths paths(balls);
  ASSERT_EQ(paths.status(), hsp::Status::ok) << oracle::to_text(balls);
  Vector low{0, 0, 0}, high{0, 0, 0};
  for (const auto &ball : balls) {
    const int64_t reach = ball.radius + ball.radius / 2 + 1;
    const bool is_first = &ball == balls.data();
    low = {is_first ? ball.x - reach : std::min(low.x, ball.x - reach),
           is_first ? ball.y - reach : std::min(low.y, ball.y - reach),
           is_first ? ball.z - reach : std::min(low.z, ball.z - reach)};
    high = {is_first ? ball.x + reach : std::max(high.x, ball.x + reach),
            is_first ? ball.y + reach : std::max(high.y, ball.y + reach),
            is_first ? ball.z + reach : std::max(high.z, ball.z + reach)};
  }
  const auto draw = [&] {
    Vector point{};
    for (int attempt = 0; attempt < 40; ++attempt) {
      point.x = random.in(low.x, high.x);
      point.y = random.in(low.y, high.y);
      point.z = random.in(low.z, high.z);
      if (is_free(balls, point, point)) break;
    }
    return point;
  };
  for (int k = 0; k < pairs; ++k) {
    const Vector from = first != nullptr && k % 2 == 0 ? *first : draw();
    const Vector to = random.one_in(30) ? from : draw();
    hsp::PathSummary summary{};
    ASSERT_EQ(paths.finder().find(paths.balls(), from, to, summary), hsp::Status::ok) << oracle::to_text(balls);
    if (!is_free(balls, from, from) || !is_free(balls, to, to)) {
      ASSERT_EQ(summary.ends, hsp::PathEnds::covered);
      ASSERT_EQ(paths.finder().points().size(), 0U);
      ++seen.covered;
      continue;
    }
    const auto cell_of = [&](const Vector &point) {
      return hsp::region_of_point(topology.grid(), topology.boundary(), topology.structure(), point);
    };
    if (cell_of(from) != cell_of(to)) {
      ASSERT_EQ(summary.ends, hsp::PathEnds::apart);
      ASSERT_EQ(paths.finder().points().size(), 0U);
      ++seen.apart;
      continue;
    }
    ASSERT_EQ(summary.ends, hsp::PathEnds::connected) << oracle::to_text(balls);
    ASSERT_NO_FATAL_FAILURE(check_path(balls, paths.finder(), summary, from, to, k % 16 == 0, seen))
        << oracle::to_text(balls);
  }
}

// A lattice of eight balls around each of eight hollows, open or closed by their radius; half the pairs begin in one.
inline void check_lattice(int64_t radius, int pairs, oracle::RandomSource &random, Seen &seen) {
  const Vector middle{5000, 5000, 5000};
  const Balls balls = oracle::box_lattice({3, 3, 3}, {10000, 10000, 10000}, radius);
  check(balls, random, pairs, seen, &middle);
}

// Centres and radii as large as a lattice may have them.
inline void check_large_numbers(int pairs, oracle::RandomSource &random, Seen &seen) {
  const Balls balls = oracle::largest_balls(random, static_cast<size_t>(random.in(2, 12)));
  ASSERT_NO_FATAL_FAILURE(check(balls, random, pairs, seen));
  const Vector far{INT64_C(1) << 50, -(INT64_C(1) << 50), INT64_C(1) << 50};
  BuiltPaths paths(balls);
  hsp::PathSummary summary{};
  ASSERT_EQ(paths.finder().find(paths.balls(), far, {-far.x, -far.y, -far.z}, summary), hsp::Status::ok);
  ASSERT_EQ(summary.ends, hsp::PathEnds::connected);
  check_path(balls, paths.finder(), summary, far, {-far.x, -far.y, -far.z}, false, seen);
}

// Atoms with van der Waals radii in steps of 1e-6 angstrom.
inline Balls molecule(const char *name, int64_t probe) {
  Balls balls = read_molecule(support::own_molecule(name));
  for (auto &ball : balls) {
    ball.radius += probe;
    for (int64_t *value : {&ball.x, &ball.y, &ball.z, &ball.radius}) *value *= 1000;
  }
  return balls;
}

}  // namespace checked_paths
