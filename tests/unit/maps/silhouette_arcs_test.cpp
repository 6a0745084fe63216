#include "maps/arc_finder.hpp"

#include "maps/ball_scene.hpp"
#include "visible_samples.hpp"

namespace {

struct FoundArcs {
  std::vector<hsp::MapArc> arcs;
  bool complete = false;

  FoundArcs(PlacedBalls &placed, uint32_t ball) {
    std::vector<uint32_t> near_memory(placed.seen.balls().size() + 1);
    hsp::FixedVector<uint32_t> near({near_memory.data(), static_cast<uint32_t>(near_memory.size())});
    placed.discs.gather(ball, near);
    std::vector<hsp::HiddenInterval> hidden_memory(2 * near_memory.size());
    hsp::FixedVector<hsp::HiddenInterval> hidden({hidden_memory.data(), static_cast<uint32_t>(hidden_memory.size())});
    std::vector<hsp::MapArc> memory(2 * near_memory.size());
    hsp::FixedVector<hsp::MapArc> found({memory.data(), static_cast<uint32_t>(memory.size())});
    complete = hsp::find_silhouette_arcs(placed.seen, ball, near.items(), hidden, found);
    EXPECT_FALSE(hidden.overflowed() || found.overflowed());
    arcs.assign(found.items().begin(), found.items().end());
  }
};

TEST(SilhouetteArcs, AreWhereTheCircleIsSeen) {
  oracle::RandomSource random(8);
  uint32_t compared = 0, found = 0;
  for (int time = 0; time < 30; ++time) {
    PlacedBalls placed(time % 2 == 0 ? oracle::loose_balls(random, 60) : oracle::clustered_balls(random, 60),
                       {3, -1, 2});
    const auto balls = placed.seen.balls();
    for (uint32_t i = 0; i < balls.size(); ++i) {
      if (balls[i].inside != 0) continue;
      const FoundArcs own(placed, i);
      found += static_cast<uint32_t>(own.arcs.size());
      compared += expect_visible_where_arcs_are(own.arcs, balls, hsp::pi, i, i,
                                                [&](double t) { return hsp::silhouette_point(balls[i], t); });
    }
  }
  EXPECT_GT(found, 500U);
  EXPECT_GT(compared, 100000U);
}

// Ends name the ball that hides what follows, and whether it is nearer.
TEST(SilhouetteArcs, NameWhatHidesTheRest) {
  PlacedBalls placed({{0, 0, 0, 5}, {4, 0, 50, 5}, {-4, 0, -1, 5}});
  // The nearest top is ball 0 of the map, then the one in question, then the farther one that it meets.
  const FoundArcs own(placed, 1);
  ASSERT_EQ(own.arcs.size(), 2U);
  for (const hsp::MapArc &arc : own.arcs) {
    const bool above = arc.from > 0;
    EXPECT_EQ(arc.end[above ? 0 : 1].kind, hsp::MapVertexKind::t);
    EXPECT_EQ(arc.end[above ? 0 : 1].body, 0U);
    EXPECT_EQ(arc.end[above ? 1 : 0].kind, hsp::MapVertexKind::tangency);
    EXPECT_EQ(arc.end[above ? 1 : 0].body, 2U);
  }
}

// Of two discs that are the same the nearer ball's silhouette is seen.
TEST(SilhouetteArcs, OfEqualDiscsAreTheNearerBalls) {
  PlacedBalls placed({{0, 0, 0, 5}, {0, 0, 6, 5}, {30, 0, 0, 5}, {30, 0, 0, 5}});
  uint32_t closed = 0;
  const auto balls = placed.seen.balls();
  for (uint32_t i = 0; i < balls.size(); ++i) {
    if (balls[i].inside != 0) continue;
    const FoundArcs own(placed, i);
    EXPECT_EQ(own.arcs.size(), balls[i].x < 0 && balls[i].z < 0 ? 0U : 1U);
    closed += static_cast<uint32_t>(own.arcs.size());
  }
  EXPECT_EQ(closed, 2U);
}

TEST(SilhouetteArcs, BehindFilledCellsAreNone) {
  PlacedBalls placed({{0, 0, 0, 400}, {0, 0, 900, 1000}, {1500, 0, -300, 600}});
  for (uint32_t i = 1; i < placed.seen.balls().size(); ++i) {
    const FoundArcs own(placed, i);
    EXPECT_EQ(own.arcs.size(), 1U);
  }
}

// Two discs that touch on the circle, and the same apart and one over the other.
TEST(SilhouetteArcs, TellWhereTwoBallsTouchThatHideThem) {
  for (const int64_t off : {-1, 0, 1}) {
    PlacedBalls placed({{0, 0, 0, 50}, {50, 20 + off, 100, 20}, {50, -20, 200, 20}});
    EXPECT_EQ(FoundArcs(placed, 2).complete, off != 0) << off;
  }
}

}  // namespace
