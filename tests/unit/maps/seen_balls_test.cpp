#include "maps/seen_balls.hpp"

#include <gtest/gtest.h>

#include "placed_balls.hpp"

namespace {

TEST(SeenBalls, ComeWithTheHighestTopsFirst) {
  oracle::RandomSource random(1);
  PlacedBalls placed(oracle::loose_balls(random, 200), {1, 2, 3});
  const auto balls = placed.seen.balls();
  ASSERT_GT(balls.size(), 50U);
  for (uint32_t k = 0; k + 1 < balls.size(); ++k) EXPECT_GE(balls[k].top(), balls[k + 1].top());
}

TEST(SeenBalls, LargerOnesComeFirstAtEqualTops) {
  PlacedBalls placed({{0, 0, 8, 2}, {1, 0, 6, 4}, {-2, 0, 6, 4}});
  const auto balls = placed.seen.balls();
  ASSERT_EQ(balls.size(), 3U);
  EXPECT_EQ(balls[0].x, -1.0);  // relative to the middle; of equal ones the first by coordinates
  EXPECT_EQ(balls[1].x, 2.0);
  EXPECT_EQ(balls[2].r, 2.0);
  EXPECT_TRUE(placed.seen.is_nearer(2, 0));
  EXPECT_FALSE(placed.seen.is_nearer(0, 2));
  EXPECT_TRUE(placed.seen.is_nearer(0, 1));
  EXPECT_FALSE(placed.seen.is_nearer(1, 0));
}

TEST(SeenBalls, LackWhatIsHiddenAsAWhole) {
  PlacedBalls placed({{0, 0, 0, 3}, {0, 0, 100, 30}, {50, 0, 0, 0}, {500, 0, 0, 3}});
  ASSERT_EQ(placed.seen.balls().size(), 2U);
  EXPECT_EQ(placed.seen.balls()[0].r, 30.0);
  EXPECT_EQ(placed.seen.balls()[1].r, 3.0);
}

TEST(SeenBalls, MoveByAtMostThePerturbation) {
  oracle::RandomSource random(2);
  oracle::Balls set = oracle::loose_balls(random, 100);
  set.push_back(set[0]);
  PlacedBalls still(set), moved(set, {0, 0, 1}, 0x1p-10);
  ASSERT_EQ(still.seen.balls().size(), moved.seen.balls().size());
  double farthest = 0;
  for (const hsp::SeenBall &a : still.seen.balls())
    for (const hsp::SeenBall &b : moved.seen.balls()) {
      if (a.ball != b.ball) continue;
      const double distance = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) / a.r;
      EXPECT_LE(distance, 0x1p-10);
      EXPECT_GT(distance, 0);
      farthest = std::max(farthest, distance);
    }
  EXPECT_GT(farthest, 0x1p-11);
  // Equal balls stay equal.
  int equal = 0;
  for (uint32_t k = 0; k + 1 < moved.seen.balls().size(); ++k) {
    const hsp::SeenBall &a = moved.seen.balls()[k];
    const hsp::SeenBall &b = moved.seen.balls()[k + 1];
    equal += a.x == b.x && a.y == b.y && a.z == b.z;
  }
  EXPECT_EQ(equal, 1);
}

TEST(SeenBalls, FloorsAreOfBallsThatAreNotMoved) {
  const oracle::Balls set = {{0, 0, 0, 1000}, {5000, 0, 0, 1000}};
  PlacedBalls still(set), moved(set, {0, 0, 1}, 0x1p-10);
  hsp::BoundingBox box;
  box.left = -2510;
  box.right = -2490;
  box.bottom = -10;
  box.top = 10;
  EXPECT_TRUE(still.seen.hides(box, 400));
  EXPECT_FALSE(still.seen.hides(box, 1000));
  EXPECT_FALSE(moved.seen.hides(box, 400));
}

TEST(SeenBalls, AreInsideOthersUpToAPartOfTheirRadii) {
  const hsp::SeenBall large{0, 0, 0, 64, 0, 0};
  const auto beside = [](double x, double r) { return hsp::SeenBall{x, 0, 0, r, 1, 0}; };
  for (const double r : {64.0, 32.0, 0.0625}) {
    const double touches = 64 - r;
    EXPECT_TRUE(hsp::is_inside(beside(touches, r), large)) << r;
    EXPECT_TRUE(hsp::is_inside(beside(touches + 0x1p-36, r), large)) << r;
    EXPECT_FALSE(hsp::is_inside(beside(touches + 0x1p-32, r), large)) << r;
  }
  EXPECT_FALSE(hsp::is_inside(beside(0, 65), large));
}

}  // namespace
