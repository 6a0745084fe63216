#include "maps/arc_finder.hpp"

#include <gtest/gtest.h>

#include "placed_balls.hpp"

namespace {

struct Finder {
  hsp::ArcFinder finder;

  Finder(PlacedBalls &placed, const hsp::MapLimits &limits) {
    memory_.carve(finder, limits);
    hsp::Patience endless;
    finder.find(placed.seen, placed.discs, endless);
  }

 private:
  CarvedMemory memory_;
};

TEST(ArcFinder, TellsWhatSuffices) {
  oracle::RandomSource random(10);
  for (int time = 0; time < 20; ++time) {
    PlacedBalls placed(oracle::loose_balls(random, 80));
    const Finder roomy(placed, {80, 80, 4000});
    ASSERT_FALSE(roomy.finder.overflowed());
    const uint32_t neighbours = roomy.finder.needed_neighbours();
    const uint32_t arcs = roomy.finder.arcs().size();
    EXPECT_TRUE(roomy.finder.certain());
    uint32_t stems = 0;
    for (const hsp::MapArc &arc : roomy.finder.arcs())
      for (const hsp::ArcEnd &end : arc.end) stems += end.kind == hsp::MapVertexKind::t;
    EXPECT_GT(stems, 0U);
    EXPECT_EQ(roomy.finder.needed_edges(), arcs + stems);
    const Finder narrow(placed, {80, neighbours - 1, 4000});
    EXPECT_TRUE(narrow.finder.overflowed());
    EXPECT_EQ(narrow.finder.needed_neighbours(), neighbours);
    const Finder tight(placed, {80, neighbours, arcs - 1});
    EXPECT_TRUE(tight.finder.overflowed());
    EXPECT_GE(tight.finder.needed_edges(), roomy.finder.needed_edges());
    const Finder exact(placed, {80, neighbours, arcs});
    EXPECT_FALSE(exact.finder.overflowed());
    EXPECT_EQ(exact.finder.arcs().size(), arcs);
  }
}

// First silhouettes, then creases, ball by ball.
TEST(ArcFinder, OrdersArcsByBalls) {
  oracle::RandomSource random(11);
  PlacedBalls placed(oracle::loose_balls(random, 80));
  const Finder all(placed, {80, 80, 4000});
  const auto arcs = all.finder.arcs();
  ASSERT_GT(arcs.size(), 50U);
  for (uint32_t a = 0; a + 1 < arcs.size(); ++a) {
    ASSERT_LE(arcs[a].body, arcs[a + 1].body);
    if (arcs[a].body != arcs[a + 1].body || arcs[a + 1].nearer != hsp::no_id) continue;
    ASSERT_EQ(arcs[a].nearer, hsp::no_id);
    ASSERT_LE(arcs[a].to, arcs[a + 1].from);
  }
}

// Three spheres through one circle: roundings would decide of each crease whether the third ball hides it.
TEST(ArcFinder, IsNotCertainOfCurvesThatCoincide) {
  PlacedBalls placed({{0, 0, -16, 20}, {0, 0, 0, 12}, {0, 0, 9, 15}}, {5, 2, 1});
  const Finder all(placed, {3, 3, 100});
  EXPECT_FALSE(all.finder.certain());
  PlacedBalls apart({{0, 0, -16, 20}, {0, 0, 0, 12}, {0, 0, 10, 15}}, {5, 2, 1});
  const Finder certain(apart, {3, 3, 100});
  EXPECT_TRUE(certain.finder.certain());
}

}  // namespace
