// Balls that touch others from inside, across the faces of a box.
#include "periodic/periodic_tangency.hpp"

#include <gtest/gtest.h>

#include <set>

#include "built_periodic.hpp"

namespace {

using Pairs = std::set<std::pair<uint32_t, uint32_t>>;

Pairs pairs_of(const support::BallList &balls) {
  const BuiltPeriodic built(balls, {16, 0, 0, 4, 16, 0, 0, -4, 16});
  EXPECT_EQ(built.status(), hsp::Status::ok);
  Pairs pairs;
  hsp::for_each_inner_tangency_in_box(built.get(), [&](uint32_t inner, uint32_t outer) {
    EXPECT_TRUE(pairs.insert({inner, outer}).second);
  });
  return pairs;
}

// The inner ball is one box away, and reaches the border of the outer one at x = 4; a third ball may cover that point.
TEST(PeriodicTangency, IsThatOfImages) {
  support::BallList balls;
  balls.add(0, 0, 0, 4);
  balls.add(18, 0, 0, 2);
  EXPECT_EQ(pairs_of(balls), (Pairs{{1, 0}}));
  balls.add(8, 12, 16, 1);  // at 4, 0, 0 and b and c from there
  EXPECT_EQ(pairs_of(balls), Pairs{});
  support::BallList deep;
  deep.add(0, 0, 0, 4);
  deep.add(17, 0, 0, 2);
  EXPECT_EQ(pairs_of(deep), Pairs{});
}

// Of equal balls the one without faces is named, once: if the other has some.
TEST(PeriodicTangency, OfEqualBallsIsThatOfOne) {
  support::BallList balls;
  balls.add(1, 1, 1, 3);
  balls.add(17, 1, 1, 3);
  const Pairs pairs = pairs_of(balls);
  EXPECT_EQ(pairs.size(), 1U);
  EXPECT_TRUE((pairs == Pairs{{0, 1}} || pairs == Pairs{{1, 0}}));
  balls.add(1, 1, 1, 5);
  EXPECT_EQ(pairs_of(balls), Pairs{});
}

}  // namespace
