// Silhouettes of maps in runs: each edge that is one appears once, angles go on, and the ends say what the map says.
#include "maps/map_silhouettes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "built_map.hpp"
#include "random_balls.hpp"

namespace {

struct Taken {
  hsp::SilhouetteArc arc;
  bool first;
};

std::vector<Taken> taken_of(const hsp::VisibilityMap &map, uint32_t ball) {
  std::vector<Taken> taken;
  const hsp::SilhouetteVisitor visitor{&taken, [](void *context, const hsp::SilhouetteArc &arc, bool first) {
                                         static_cast<std::vector<Taken> *>(context)->push_back({arc, first});
                                       }};
  hsp::silhouettes_of(map).visit(ball, visitor);
  return taken;
}

TEST(MapSilhouettes, AreTheSilhouettesOfTheMap) {
  oracle::RandomSource random(12);
  size_t under = 0, creased = 0, gone_on = 0, crossed = 0;
  for (int time = 0; time < 10; ++time) {
    const BuiltMap built(oracle::loose_balls(random, 60), {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    size_t expected = 0, found = 0;
    double span = 0, expected_span = 0;
    for (const hsp::MapEdge &edge : map.edges.items()) {
      if (!edge.is_silhouette()) continue;
      ++expected;
      expected_span += edge.to - edge.from;
    }
    for (uint32_t ball = 0; ball < 60; ++ball) {
      const std::vector<Taken> taken = taken_of(map, ball);
      found += taken.size();
      for (size_t k = 0; k < taken.size(); ++k) {
        const hsp::SilhouetteArc &arc = taken[k].arc;
        span += arc.to - arc.from;
        EXPECT_LE(arc.from, arc.to);
        EXPECT_NE(arc.behind, ball);
        EXPECT_FALSE(arc.start.goes_on && arc.start.goes_under);
        for (const hsp::SilhouetteArc::End *end : {&arc.start, &arc.end}) {
          gone_on += end->goes_on ? 1 : 0;
          under += end->goes_under ? 1 : 0;
          creased += !end->goes_on && !end->goes_under ? 1 : 0;
          crossed += end->goes_on && end->crossed != hsp::no_id ? 1 : 0;
          if (end->goes_under) {
            EXPECT_EQ(end->other, end->crossed);
          }
        }
        if (k == 0 || taken[k].first) {
          EXPECT_TRUE(taken[k].first);
          continue;
        }
        const hsp::SilhouetteArc &before = taken[k - 1].arc;
        EXPECT_TRUE(before.end.goes_on && arc.start.goes_on);
        EXPECT_NEAR(before.to, arc.from, 1e-6);
        EXPECT_EQ(before.end.other, arc.behind);
        EXPECT_EQ(arc.start.other, before.behind);
      }
    }
    EXPECT_EQ(found, expected);
    EXPECT_NEAR(span, expected_span, 1e-6);
  }
  EXPECT_GT(under, 100U);
  EXPECT_GT(creased, 100U);
  EXPECT_GT(gone_on, 100U);
  EXPECT_GT(crossed, 20U);
}

// A small ball before a large one, and beside it: the background is no ball, and whole circles go on where they begin.
TEST(MapSilhouettes, OfAWholeCircle) {
  const BuiltMap built({{0, 0, 0, 1000}, {100, 0, 5000, 200}}, {0, 0, 1});
  const hsp::VisibilityMap &map = built.map();
  size_t before_a_ball = 0, before_nothing = 0;
  for (uint32_t ball = 0; ball < 2; ++ball) {
    const std::vector<Taken> taken = taken_of(map, ball);
    ASSERT_EQ(taken.size(), 1U);
    const hsp::SilhouetteArc &arc = taken[0].arc;
    EXPECT_NEAR(arc.to - arc.from, 2 * std::numbers::pi, 1e-9);
    EXPECT_TRUE(arc.start.goes_on && arc.end.goes_on);
    EXPECT_EQ(arc.start.other, arc.behind);
    EXPECT_EQ(arc.start.crossed, hsp::no_id);
    if (arc.behind == hsp::no_id) {
      ++before_nothing;
    } else {
      EXPECT_EQ(arc.behind, 1 - ball);
      ++before_a_ball;
    }
  }
  EXPECT_EQ(before_a_ball, 1U);
  EXPECT_EQ(before_nothing, 1U);
}

}  // namespace
