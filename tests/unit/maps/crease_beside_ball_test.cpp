#include "maps/crease_beside_ball.hpp"

#include "random_numbers.hpp"

#include <gtest/gtest.h>

namespace {

// Held against many points of the part. All balls are about as large, as those that meet in a crease are.
TEST(CreaseBesideBall, AsManyPointsOfTheCreaseHaveIt) {
  support::Random random(12);
  uint32_t decided[3] = {0, 0, 0};
  for (int turn = 0; turn < 20000; ++turn) {
    const double spread = turn % 3 == 0 ? 1e-4 : turn % 3 == 1 ? 0.1 : 1.5;
    const auto off = [&] { return spread * (2.0 * random.fraction() - 1.0); };
    hsp::SeenBall ball[3];
    for (hsp::SeenBall &own : ball) own = {off(), off(), off(), 1.0 + 0.3 * off(), 0, 0};
    const hsp::Crease crease(ball[0], ball[1]);
    if (!crease.exists) continue;
    const double first = crease.end * (2.0 * random.fraction() - 1.0);
    const hsp::PartOfCrease part(
        {turn % 4 == 0 ? -crease.end : first, first + (crease.end - first) * random.fraction()});
    const int side = hsp::CreaseBesideBall(crease, ball[2]).side_of({&part, 1});
    bool some_behind = false, all_behind = true;
    constexpr int points = 200;
    for (int k = 0; k <= points; ++k) {
      const double t = part.ends.from + (part.ends.to - part.ends.from) * k / points;
      const bool behind = depth_behind(crease.at(t), ball[2]) > 0.0;
      some_behind = some_behind || behind;
      all_behind = all_behind && behind;
    }
    const int seen = all_behind ? 1 : some_behind ? 0 : -1;
    ++decided[side == 0 ? 2 : side > 0 ? 1 : 0];
    if (side != 0) {
      ASSERT_EQ(side, seen) << turn;
    }
  }
  EXPECT_GT(decided[0], 1000U);
  EXPECT_GT(decided[1], 1000U);
  EXPECT_GT(decided[2], 1000U);
}

}  // namespace
