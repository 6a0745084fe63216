// The stages of the predicates against each other: the filter is sure only where the exact stage agrees, both limb
// widths give the same signs, and what a predicate says does not depend on which ball it is asked from.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/predicates.hpp"
#include "four_balls.hpp"

namespace {

using namespace hsp::exact;
using Narrow = ExactPredicates<uint32_t>;

TEST(PredicateRungs, TheFilterNeverContradictsAndLimbWidthsAgree) {
  oracle::RandomSource random(5);
  int ties = 0;
  int certain = 0;
  for (int k = 0; k < 300000; ++k) {
    const FourBalls four = random_four_balls(random);
    const FilterBounds bounds = FilterBounds::for_length_squared(four.length_squared());
    const Sphere sphere = four.sphere();
    const Plane P = four.plane(1), Q = four.plane(2), R = four.plane(3);

    const Sign crossing = Exact::crossing(sphere, P, Q);
    const Sign crossing_narrow = Narrow::crossing(sphere, P, Q);
    ASSERT_EQ(crossing.sign, crossing_narrow.sign);
    ASSERT_EQ(crossing.tied, crossing_narrow.tied);
    ties += crossing.tied;
    if (const int sign = filter_crossing(bounds, sphere, P, Q); sign != 0) {
      ++certain;
      ASSERT_EQ(sign, crossing.sign);
      ASSERT_FALSE(crossing.tied);
    }
    if (crossing.sign < 0) {
      const Sign side = Exact::side(sphere, P, R);
      ASSERT_EQ(side.sign, Narrow::side(sphere, P, R).sign);
      if (const int sign = filter_side(bounds, P, R); sign != 0) {
        ASSERT_EQ(sign, side.sign);
      }
      continue;
    }
    const PointStatus status = Exact::point_status(sphere, P, Q, R);
    const PointStatus narrow = Narrow::point_status(sphere, P, Q, R);
    PointStatus filtered;
    const bool sure = filter_point_status(bounds, sphere, P, Q, R, filtered);
    certain += sure;
    for (int point = 0; point < 2; ++point) {
      ASSERT_NE(status.side[point], 0);
      ASSERT_EQ(status.side[point], narrow.side[point]);
      ASSERT_EQ(status.tied[point], narrow.tied[point]);
      ties += status.tied[point];
      if (sure) {
        ASSERT_EQ(filtered.side[point], status.side[point]);
        ASSERT_FALSE(status.tied[point]);
      }
    }
    // Exchanging P and Q exchanges p+ and p-.
    const PointStatus exchanged = Exact::point_status(sphere, Q, P, R);
    ASSERT_EQ(exchanged.side[0], status.side[1]);
    ASSERT_EQ(exchanged.side[1], status.side[0]);
  }
  EXPECT_GT(ties, 100000);
  EXPECT_GT(certain, 100000);
}

TEST(PredicateRungs, APointIsJudgedAlikeFromItsThreeBalls) {
  oracle::RandomSource random(6);
  int judged = 0;
  for (int k = 0; k < 100000; ++k) {
    const FourBalls four = random_four_balls(random);
    const auto &ball = four.ball;
    // Balls 0, 1, 2 in cyclic order carry the vertex, ball 3 is asked about.
    if (pair_relation(ball[1], ball[2]) != PairRelation::circle ||
        pair_relation(ball[1], ball[3]) != PairRelation::circle ||
        pair_relation(ball[2], ball[3]) != PairRelation::circle) {
      continue;
    }
    PointStatus first{};
    for (int turn = 0; turn < 3; ++turn) {
      const LatticeBall &origin = ball[turn];
      const Plane P = plane_of(origin, ball[(turn + 1) % 3]);
      const Plane Q = plane_of(origin, ball[(turn + 2) % 3]);
      const Sphere sphere = sphere_of(origin);
      const Sign crossing = Exact::crossing(sphere, P, Q);
      if (turn > 0) {
        ASSERT_EQ(crossing.sign > 0, first.side[0] != 0);
      }
      if (crossing.sign < 0) continue;
      const PointStatus status = Exact::point_status(sphere, P, Q, plane_of(origin, ball[3]));
      if (turn == 0) first = status;
      for (int point = 0; point < 2; ++point) {
        ASSERT_EQ(status.side[point], first.side[point]);
        ASSERT_EQ(status.tied[point], first.tied[point]);
      }
      ++judged;
    }
  }
  EXPECT_GT(judged, 30000);
}

// The values of the filter at the worst inputs a search finds, against exact values, in units of the stated bounds.
TEST(PredicateRungs, FilterErrorsStayBelowTheirBounds) {
  oracle::RandomSource random(8);
  double worst = 0.0;
  for (int k = 0; k < 200000; ++k) {
    const FourBalls four = random_four_balls(random);
    const FilterBounds bounds = FilterBounds::for_length_squared(four.length_squared());
    const Sphere sphere = four.sphere();
    const Plane P = four.plane(1), Q = four.plane(2), R = four.plane(3);
    const Vector n = cross(P.v, Q.v);
    if (is_zero(n)) continue;
    const hsp::Vec3 dn = to_double(n);
    const hsp::Vec3 q = combine(static_cast<double>(P.h), to_double(Q.v), -static_cast<double>(Q.h), to_double(P.v));
    const double D = static_cast<double>(sphere.W) * dot(dn, dn) - dot(q, q);
    const double exact_D = Exact::discriminant(sphere, P, Q);
    if (exact_D > 0.0) worst = std::max(worst, std::fabs(D - exact_D) / bounds.D);
    const double B = dot(dn, to_double(R.v));
    worst = std::max(worst, std::fabs(B - Exact::triple_product(P.v, Q.v, R.v)) / bounds.B);
    const double beta = static_cast<double>(R.h) * static_cast<double>(dot(P.v, P.v)) -
                        static_cast<double>(P.h) * static_cast<double>(dot(P.v, R.v));
    worst = std::max(worst, std::fabs(beta - Exact::radical_coordinate(P, R)) / bounds.beta);
  }
  EXPECT_LT(worst, 1.0);
  EXPECT_GT(worst, 0.0);
}

}  // namespace
