#include "maps/arc_finder.hpp"

#include "maps/ball_scene.hpp"
#include "set_arrangements.hpp"
#include "visible_samples.hpp"

namespace {

std::vector<hsp::MapArc> crease_arcs(PlacedBalls &placed, uint32_t far, uint32_t nearer, uint32_t &hider,
                                     bool *certain = nullptr) {
  std::vector<uint32_t> near_memory(placed.seen.balls().size() + 1);
  hsp::FixedVector<uint32_t> near({near_memory.data(), static_cast<uint32_t>(near_memory.size())});
  placed.discs.gather(far, near);
  std::vector<hsp::HiddenInterval> hidden_memory(hsp::most_hidden_per_occluder * near_memory.size());
  hsp::FixedVector<hsp::HiddenInterval> hidden({hidden_memory.data(), static_cast<uint32_t>(hidden_memory.size())});
  std::vector<hsp::MapArc> memory(hidden_memory.size() + 2);
  hsp::FixedVector<hsp::MapArc> found({memory.data(), static_cast<uint32_t>(memory.size())});
  const bool is_certain = hsp::find_crease_arcs(placed.seen, far, nearer, near.items(), hidden, found, hider);
  if (certain != nullptr) *certain = is_certain;
  EXPECT_FALSE(hidden.overflowed() || found.overflowed());
  return {found.items().begin(), found.items().end()};
}

std::vector<hsp::MapArc> crease_arcs(PlacedBalls &placed, uint32_t far, uint32_t nearer, bool *certain = nullptr) {
  uint32_t hider = hsp::no_id;
  return crease_arcs(placed, far, nearer, hider, certain);
}

// Some balls, each many times, nearly: most creases are hidden by a ball that comes late, and often by the same as the
// one before.
TEST(CreaseArcs, OfManyBallsInFewPlaces) {
  oracle::RandomSource random(10);
  uint32_t compared = 0, found = 0, hidden_by_one = 0;
  for (const int64_t apart : {100000, 3000000, 30000000}) {
    const auto within = [&](int64_t most) { return random.in(-most, most); };
    oracle::Balls set;
    for (int place = 0; place < 8; ++place) {
      const int64_t x = within(150000000), y = within(150000000), z = within(150000000);
      for (int k = 0; k < 15; ++k) {
        const int64_t at[3] = {x + within(apart), y + within(apart), z + within(apart)};
        set.push_back({at[0], at[1], at[2], 100000000 + within(apart)});
      }
    }
    PlacedBalls placed(set, {3, -1, 2});
    const auto balls = placed.seen.balls();
    for (uint32_t i = 0; i < balls.size(); ++i) {
      uint32_t hider = hsp::no_id;
      for (uint32_t j = 0; j < balls.size(); ++j) {
        if (i == j || !placed.seen.is_nearer(j, i) || balls[i].inside != 0 || balls[j].inside != 0) continue;
        const hsp::Crease crease(balls[i], balls[j]);
        if (!crease.exists) continue;
        const auto arcs = crease_arcs(placed, i, j, hider);
        hidden_by_one += hider != hsp::no_id;
        found += static_cast<uint32_t>(arcs.size());
        compared +=
            expect_visible_where_arcs_are(arcs, balls, crease.end, i, j, [&](double t) { return crease.at(t); });
      }
    }
  }
  EXPECT_GT(found, 50U);
  EXPECT_GT(hidden_by_one, 300U);
  EXPECT_GT(compared, 20000U);
}

TEST(CreaseArcs, AreWhereTheCreaseIsSeen) {
  oracle::RandomSource random(9);
  uint32_t compared = 0, found = 0, triples = 0, stems = 0, whole = 0;
  for (int time = 0; time < 40; ++time) {
    PlacedBalls placed(time % 2 == 0 ? oracle::loose_balls(random, 60) : oracle::belted_balls(random, 60), {3, -1, 2});
    const auto balls = placed.seen.balls();
    for (uint32_t i = 0; i < balls.size(); ++i)
      for (uint32_t j = 0; j < balls.size(); ++j) {
        if (i == j || !placed.seen.is_nearer(j, i) || balls[i].inside != 0 || balls[j].inside != 0) continue;
        const hsp::Crease crease(balls[i], balls[j]);
        if (!crease.exists) continue;
        const auto arcs = crease_arcs(placed, i, j);
        found += static_cast<uint32_t>(arcs.size());
        compared +=
            expect_visible_where_arcs_are(arcs, balls, crease.end, i, j, [&](double t) { return crease.at(t); });
        for (const hsp::MapArc &arc : arcs) {
          whole += arc.closed;
          for (const hsp::ArcEnd &end : arc.end) {
            triples += end.kind == hsp::MapVertexKind::triple;
            stems += end.kind == hsp::MapVertexKind::t;
          }
        }
      }
  }
  EXPECT_GT(found, 300U);
  EXPECT_GT(compared, 50000U);
  EXPECT_GT(triples, 100U);
  EXPECT_GT(stems, 100U);
  EXPECT_GT(whole, 0U);
}

// A crease seen edge on is a segment, which is hidden like any other.
TEST(CreaseArcs, OfLevelBallsAreSegments) {
  PlacedBalls placed({{0, 0, 0, 50}, {60, 0, 0, 50}, {30, 40, 70, 20}});
  // The topmost ball is 0.
  const auto arcs = crease_arcs(placed, 2, 1);
  ASSERT_EQ(arcs.size(), 1U);  // the third disc covers y from 20 to 60 of the segment from -40 to 40
  const hsp::Crease crease(placed.seen.balls()[2], placed.seen.balls()[1]);
  const int hidden = crease.at(arcs[0].to).y > crease.at(arcs[0].from).y ? 1 : 0;
  EXPECT_EQ(arcs[0].end[hidden].kind, hsp::MapVertexKind::t);
  EXPECT_EQ(arcs[0].end[hidden].body, 0U);
  EXPECT_EQ(arcs[0].end[1 - hidden].kind, hsp::MapVertexKind::tangency);
  EXPECT_NEAR(crease.at(hidden == 1 ? arcs[0].to : arcs[0].from).y, placed.seen.balls()[0].y - 20, 1e-9);
}

// Whether all creases of some balls are certain.
bool are_certain(PlacedBalls &placed) {
  bool all = true;
  const uint32_t n = placed.seen.balls().size();
  for (uint32_t i = 0; i < n; ++i)
    for (uint32_t j = 0; j < n; ++j) {
      bool certain = true;
      if (i != j && placed.seen.is_nearer(j, i)) crease_arcs(placed, i, j, &certain);
      all = all && certain;
    }
  return all;
}

// A ball before another one whose silhouette is the circle in which both meet.
TEST(CreaseArcs, AreUncertainOnTheSilhouetteOfTheNearerBall) {
  const oracle::Balls balls = oracle::scaled({{-2, 4, -2, 1}, {-2, 0, 4, 3}, {4, 4, 0, 4}, {-2, 2, 0, 3}}, 50000000);
  PlacedBalls level(balls, {0, 1, -1});
  EXPECT_FALSE(are_certain(level));
  PlacedBalls beside(balls, {0, 3, -2});
  EXPECT_TRUE(are_certain(beside));
}

// Three spheres that meet at the height of a centre.
TEST(CreaseArcs, AreUncertainWhereTheyEnterABallAtTheHeightOfItsCentre) {
  const oracle::Balls balls = {{-4, 0, 0, 1}, {-2, -4, 0, 4}, {-2, 0, 2, 3}};
  PlacedBalls placed(balls, {-1, 0, -1});
  EXPECT_FALSE(are_certain(placed));
  PlacedBalls beside(balls, {-7, 1, -8});
  EXPECT_TRUE(are_certain(beside));
}

}  // namespace
