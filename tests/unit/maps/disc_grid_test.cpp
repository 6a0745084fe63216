#include "maps/disc_grid.hpp"

#include <gtest/gtest.h>

#include "placed_balls.hpp"
#include "set_arrangements.hpp"

namespace {

using hsp::SeenBall;

bool within(const SeenBall &inner, const SeenBall &outer) {
  return inner.r <= outer.r && std::hypot(inner.x - outer.x, inner.y - outer.y, inner.z - outer.z) <= outer.r - inner.r;
}

// Of many balls the squares collide.
oracle::Balls balls_for(oracle::RandomSource &random, int time) {
  return time % 10 == 9 ? oracle::colliding_balls(random, 250) : oracle::any_balls(random, 60);
}
std::array<double, 3> towards(int time) {
  return time % 10 == 9 ? std::array<double, 3>{0, 0, 1} : std::array<double, 3>{1, -2, 3};
}

TEST(DiscGrid, GathersWhatMeetsTheDiscAndReachesHigher) {
  oracle::RandomSource random(3);
  for (int time = 0; time < 60; ++time) {
    PlacedBalls placed(balls_for(random, time), towards(time));
    const auto balls = placed.seen.balls();
    std::vector<uint32_t> memory(balls.size() + 1);
    for (uint32_t i = 0; i < balls.size(); ++i) {
      hsp::FixedVector<uint32_t> near(hsp::Span<uint32_t>(memory.data(), balls.size()));
      placed.discs.gather(i, near);
      std::vector<uint32_t> expected;
      for (uint32_t k = 0; k < balls.size(); ++k) {
        const double dx = balls[k].x - balls[i].x;
        const double dy = balls[k].y - balls[i].y;
        const double sum = balls[k].r + balls[i].r;
        if (k != i && balls[k].inside == 0 && balls[k].top() > balls[i].z && dx * dx + dy * dy < sum * sum)
          expected.push_back(k);
      }
      ASSERT_EQ(std::vector<uint32_t>(near.items().begin(), near.items().end()), expected);
    }
  }
}

TEST(DiscGrid, CountsWhatThereIsNoRoomFor) {
  PlacedBalls placed({{0, 0, 0, 10}, {1, 1, 9, 9}, {-3, 0, 8, 9}, {0, -5, 7, 9}});
  uint32_t one = 0;
  hsp::FixedVector<uint32_t> near(hsp::Span<uint32_t>(&one, 1));
  placed.discs.gather(3, near);
  EXPECT_EQ(near.required(), 3U);
}

// Of equal balls one stays outside.
TEST(DiscGrid, MarksWhatIsInsideOthers) {
  oracle::RandomSource random(4);
  int inside = 0;
  for (int time = 0; time < 200; ++time) {
    PlacedBalls placed(oracle::repeated_balls(random, 30));
    const auto balls = placed.seen.balls();
    for (uint32_t i = 0; i < balls.size(); ++i) {
      bool expected = false;
      for (uint32_t k = 0; k < balls.size(); ++k)
        expected |= k != i && within(balls[i], balls[k]) && (k < i || !within(balls[k], balls[i]));
      ASSERT_EQ(balls[i].inside != 0, expected);
      inside += expected;
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(DiscGrid, FindsTheHighestFront) {
  oracle::RandomSource random(5);
  int found = 0;
  for (int time = 0; time < 60; ++time) {
    PlacedBalls placed(balls_for(random, time), towards(time));
    const auto balls = placed.seen.balls();
    for (const SeenBall &from : balls)
      for (const uint32_t except : {hsp::no_id, random.below(balls.size())}) {
        const double x = from.x + (2 * random.fraction() - 1) * 1.2 * from.r;
        const double y = from.y + (2 * random.fraction() - 1) * 1.2 * from.r;
        double highest = -1e300;
        for (uint32_t k = 0; k < balls.size(); ++k) {
          const double dx = x - balls[k].x;
          const double dy = y - balls[k].y;
          const double squared = balls[k].r * balls[k].r - dx * dx - dy * dy;
          if (k != except && balls[k].inside == 0 && squared > 0)
            highest = std::max(highest, balls[k].z + std::sqrt(squared));
        }
        const uint32_t best = placed.discs.highest_at(x, y, except).body;
        ASSERT_EQ(best == hsp::no_id, highest == -1e300);
        if (best == hsp::no_id) continue;
        ++found;
        const double dx = x - balls[best].x;
        const double dy = y - balls[best].y;
        ASSERT_EQ(balls[best].z + std::sqrt(balls[best].r * balls[best].r - dx * dx - dy * dy), highest);
      }
  }
  EXPECT_GT(found, 1000);
}

// Not on the edge of a disc, nor where two fronts meet, unless something higher covers that.
TEST(DiscGrid, TellsWhereTheHighestFrontIsUncertain) {
  PlacedBalls placed({{-60, 0, 0, 50}, {0, 0, 0, 50}, {60, 0, 0, 50}});
  const auto certain = [&](double x, double y) { return placed.discs.highest_at(x, y, hsp::no_id).certain; };
  EXPECT_TRUE(certain(0, 0));
  EXPECT_FALSE(certain(30, 10));
  EXPECT_FALSE(certain(0, 50));
  EXPECT_FALSE(certain(110, 0));
  EXPECT_TRUE(certain(0, 51));
  EXPECT_TRUE(certain(40, 0));
  PlacedBalls covered({{-60, 0, 0, 50}, {0, 0, 0, 50}, {60, 0, 0, 50}, {30, 10, 200, 20}});
  const hsp::SeenBall &cover = covered.seen.balls()[0];
  EXPECT_TRUE(covered.discs.highest_at(cover.x, cover.y, hsp::no_id).certain);
  EXPECT_FALSE(covered.discs.highest_at(cover.x, cover.y, 0).certain);
}

// A ball that touches another one from inside at its highest point, and is the higher one for roundings.
TEST(DiscGrid, MarksBallsInsideThatReachAsHigh) {
  const oracle::Balls balls = {{0, 0, 0, 10}, {-1, 2, -2, 7}, {-6, -4, -12, 4}, {-4, -2, -4, 3}, {-12, -6, -4, 4}};
  PlacedBalls placed(oracle::scaled(balls, 50000000), {-1, 2, -2});
  bool higher = false;
  for (const hsp::SeenBall &ball : placed.seen.balls()) {
    if (ball.r == 7.0 * 50000000) {
      EXPECT_EQ(ball.inside, 1U);
      higher = true;
    } else if (ball.r == 10.0 * 50000000) {
      EXPECT_EQ(ball.inside, 0U);
      EXPECT_TRUE(higher) << "the larger ball comes first";
    }
  }
}

}  // namespace
