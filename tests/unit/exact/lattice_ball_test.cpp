// Two balls, and directions around an axis.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/angular_order.hpp"
#include "exact/lattice_ball.hpp"

namespace {

using namespace hsp::exact;

LatticeBall ball(int64_t x, int64_t y, int64_t z, int64_t radius, uint32_t index) {
  return {{x, y, z}, radius, index};
}

TEST(PairRelation, TangentBallsFollowTheTieRule) {
  // Outside: the closed balls meet, so there is an infinitesimal circle, whichever ranks first.
  EXPECT_EQ(pair_relation(ball(0, 0, 0, 2, 0), ball(5, 0, 0, 3, 1)), PairRelation::circle);
  EXPECT_EQ(pair_relation(ball(5, 0, 0, 3, 0), ball(0, 0, 0, 2, 1)), PairRelation::circle);
  EXPECT_EQ(pair_relation(ball(0, 0, 0, 2, 0), ball(6, 0, 0, 3, 1)), PairRelation::disjoint);
  // Inside: the small ball pokes out if it ranks first (smaller x), else it is swallowed.
  EXPECT_EQ(pair_relation(ball(-1, 0, 0, 2, 0), ball(0, 0, 0, 3, 1)), PairRelation::circle);
  EXPECT_EQ(pair_relation(ball(1, 0, 0, 2, 0), ball(0, 0, 0, 3, 1)), PairRelation::first_in_second);
  // Equal balls: the lower index contains the other.
  EXPECT_EQ(pair_relation(ball(1, 2, 3, 4, 0), ball(1, 2, 3, 4, 1)), PairRelation::second_in_first);
  EXPECT_EQ(pair_relation(ball(1, 2, 3, 4, 7), ball(1, 2, 3, 4, 1)), PairRelation::first_in_second);
  // Points.
  EXPECT_EQ(pair_relation(ball(1, 2, 3, 0, 0), ball(1, 2, 3, 0, 1)), PairRelation::second_in_first);
  EXPECT_EQ(pair_relation(ball(1, 2, 3, 0, 0), ball(1, 2, 4, 0, 1)), PairRelation::disjoint);
  EXPECT_EQ(pair_relation(ball(-5, 0, 0, 0, 0), ball(0, 0, 0, 5, 1)), PairRelation::circle);
  EXPECT_EQ(pair_relation(ball(5, 0, 0, 0, 0), ball(0, 0, 0, 5, 1)), PairRelation::first_in_second);
}

TEST(PairRelation, LargestValuesDoNotOverflow) {
  const int64_t r = (int64_t{1} << 30) - 1;
  const int64_t far = int64_t{1} << 50;
  EXPECT_EQ(pair_relation(ball(far, far, far, r, 0), ball(-far, -far, -far, r, 1)), PairRelation::disjoint);
  EXPECT_EQ(pair_relation(ball(0, 0, 0, r, 0), ball(2 * r, 0, 0, r, 1)), PairRelation::circle);
  EXPECT_EQ(pair_relation(ball(0, 0, 0, r, 0), ball(2 * r, 2 * r, 2 * r, r, 1)), PairRelation::disjoint);
  const Plane plane = plane_of(ball(0, 0, 0, r, 0), ball(2 * r, 0, 0, r, 1));
  EXPECT_EQ(plane.h, 4 * r * r);
}

TEST(PairRelation, SwapsWithItsArguments) {
  std::mt19937_64 random(2);
  const auto small = [&random](int64_t range) { return static_cast<int64_t>(random() % static_cast<uint64_t>(range)); };
  for (int k = 0; k < 100000; ++k) {
    const LatticeBall a = ball(small(4), small(4), small(4), small(4), 0);
    const LatticeBall b = ball(small(4), small(4), small(4), small(4), 1);
    const PairRelation forward = pair_relation(a, b);
    const PairRelation backward = pair_relation(b, a);
    if (forward == PairRelation::first_in_second) {
      EXPECT_EQ(backward, PairRelation::second_in_first);
    } else if (forward == PairRelation::second_in_first) {
      EXPECT_EQ(backward, PairRelation::first_in_second);
    } else {
      EXPECT_EQ(backward, forward);
    }
  }
}

TEST(CyclicOrder, AgreesWithAngles) {
  std::mt19937_64 random(4);
  const auto coordinate = [&random]() { return static_cast<int64_t>(random() % 21) - 10; };
  for (int k = 0; k < 50000; ++k) {
    const Vector axis{coordinate(), coordinate(), coordinate()};
    const Vector reference{coordinate(), coordinate(), coordinate()};
    const Vector v{coordinate(), coordinate(), coordinate()};
    const Vector w{coordinate(), coordinate(), coordinate()};
    const auto angle = [&](const Vector &direction) {
      const Vector across = cross(axis, reference);
      const double length = std::sqrt(static_cast<double>(dot(axis, axis)));
      const double sine = static_cast<double>(dot(across, direction)) * length;
      const double cosine = static_cast<double>(dot(across, cross(axis, direction)));
      const double to_view = std::atan2(sine, cosine);
      return to_view < 0.0 ? to_view + 2 * 3.14159265358979323846 : to_view;
    };
    if (is_zero(cross(axis, reference)) || is_zero(cross(axis, v)) || is_zero(cross(axis, w))) continue;
    const double angle_v = angle(v);
    const double angle_w = angle(w);
    if (std::fabs(angle_v - angle_w) < 1e-9 || std::fabs(angle_v - angle_w) > 6.2831) continue;
    EXPECT_EQ(counter_clockwise_before(axis, reference, v, w), angle_v < angle_w);
    if (angle_v > 1e-9 && angle_w > 1e-9) {
      EXPECT_EQ(strictly_between(axis, reference, v, w), angle_v < angle_w);
    }
    EXPECT_TRUE(strictly_between(axis, v, w, v));
  }
}

}  // namespace
