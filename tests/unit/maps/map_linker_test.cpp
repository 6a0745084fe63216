#include "maps/map_linker.hpp"

#include <gtest/gtest.h>

#include "maps/arc_finder.hpp"
#include "placed_balls.hpp"

namespace {

using hsp::MapArc;
using hsp::MapVertexKind;

// The arcs of some balls, open to be broken, and what they are linked to.
class Linked {
 public:
  explicit Linked(PlacedBalls &placed) : placed_(placed) {
    const hsp::MapLimits limits{placed.size(), placed.size(), 4000};
    finder_memory_.carve(finder_, limits);
    linker_memory_.carve(linker_, hsp::MapSizes{placed.size(), placed.size(), limits.edges});
    map_memory_.carve(map, limits.edges);
    hsp::Patience endless;
    finder_.find(placed.seen, placed.discs, endless);
    arcs.assign(finder_.arcs().begin(), finder_.arcs().end());
  }
  bool link() {
    map.clear();
    map.scene.balls = placed_.seen.balls();
    const hsp::Span<const MapArc> span(arcs.data(), static_cast<uint32_t>(arcs.size()));
    edges = linker_.count_edges(span, map.scene);
    hsp::Patience endless;
    return linker_.link(map, endless);
  }

  std::vector<MapArc> arcs;
  hsp::VisibilityMap map;
  uint64_t edges = 0;

 private:
  PlacedBalls &placed_;
  hsp::ArcFinder finder_;
  hsp::MapLinker<hsp::BallScene> linker_;
  CarvedMemory finder_memory_, linker_memory_, map_memory_;
};

TEST(MapLinker, LinksWhatItCounts) {
  oracle::RandomSource random(12);
  for (int time = 0; time < 30; ++time) {
    PlacedBalls placed(oracle::loose_balls(random, 80), {1, 2, 3});
    Linked linked(placed);
    ASSERT_TRUE(linked.link());
    EXPECT_EQ(linked.map.edges.size(), linked.edges);
    EXPECT_LE(linked.map.vertices.size(), linked.edges);
    std::vector<int> leaving(linked.map.vertices.size(), 0);
    for (uint32_t h = 0; h < linked.map.half_edges.size(); ++h) {
      ++leaving[linked.map.origin(h)];
      EXPECT_EQ(linked.map.origin(linked.map.half_edges[h].next), linked.map.origin(h ^ 1U));
    }
    for (uint32_t v = 0; v < linked.map.vertices.size(); ++v) {
      const hsp::MapVertex &vertex = linked.map.vertices[v];
      const bool three = vertex.kind == MapVertexKind::triple || vertex.kind == MapVertexKind::t;
      EXPECT_EQ(leaving[v], three ? 3 : 2);
      EXPECT_EQ(linked.map.origin(vertex.leaving), v);
    }
  }
}

// Around a vertex of three the half-edges that follow each other go the same way round: clockwise, with the face on the
// left.
TEST(MapLinker, TurnsLeftMost) {
  PlacedBalls placed({{0, 0, 0, 50}, {60, 0, 1, 50}, {30, 50, 2, 50}});
  Linked linked(placed);
  ASSERT_TRUE(linked.link());
  const hsp::VisibilityMap &map = linked.map;
  // Three silhouette arcs, three creases that meet above, and a tangency at the outer end of each.
  EXPECT_EQ(map.vertices.size(), 7U);
  EXPECT_EQ(map.edges.size(), 9U);
  int triples = 0, stems = 0, tangencies = 0;
  for (const hsp::MapVertex &vertex : map.vertices.items()) {
    triples += vertex.kind == MapVertexKind::triple;
    stems += vertex.kind == MapVertexKind::t;
    tangencies += vertex.kind == MapVertexKind::tangency;
  }
  EXPECT_EQ(triples, 1);
  EXPECT_EQ(stems, 3);
  EXPECT_EQ(tangencies, 3);
}

TEST(MapLinker, RefusesEndsWithoutPartners) {
  oracle::RandomSource random(13);
  PlacedBalls placed(oracle::loose_balls(random, 80), {1, 2, 3});
  Linked linked(placed);
  ASSERT_TRUE(linked.link());
  const std::vector<MapArc> good = linked.arcs;
  int broken[4] = {};
  for (uint32_t a = 0; a < good.size(); ++a) {
    // Without this arc.
    linked.arcs = good;
    linked.arcs.erase(linked.arcs.begin() + a);
    bool common = false;
    for (const hsp::ArcEnd &end : good[a].end)
      common |= end.kind == MapVertexKind::triple || end.kind == MapVertexKind::tangency;
    if (common) {
      EXPECT_FALSE(linked.link()) << a;
    }
    for (uint32_t end = 0; end < 2; ++end) {
      const MapVertexKind kind = good[a].end[end].kind;
      if (kind != MapVertexKind::triple) continue;
      linked.arcs = good;
      ++broken[static_cast<int>(kind)];
      linked.arcs[a].end[end].kind = MapVertexKind::t;
      EXPECT_FALSE(linked.link()) << a;
    }
  }
  EXPECT_GT(broken[1], 10);
}

// As where roundings have hidden what a silhouette is joined with where angles begin.
TEST(MapLinker, RefusesOpenArcsThatEndNowhere) {
  PlacedBalls placed({{0, 0, 0, 50}, {60, 0, 1, 50}, {30, 50, 2, 50}});
  Linked linked(placed);
  ASSERT_TRUE(linked.link());
  const std::vector<MapArc> good = linked.arcs;
  for (uint32_t end = 0; end < 2 * good.size(); ++end) {
    linked.arcs = good;
    linked.arcs[end / 2].end[end % 2] = {MapVertexKind::plain, hsp::no_id};
    EXPECT_FALSE(linked.link()) << end;
  }
}

// A stem that ends beside all arcs of its silhouette.
TEST(MapLinker, RefusesStemsThatDoNotLand) {
  PlacedBalls placed({{0, 0, 0, 50}, {60, 0, 100, 50}, {200, 0, 0, 20}});
  Linked linked(placed);
  ASSERT_TRUE(linked.link());
  const std::vector<MapArc> good = linked.arcs;
  for (uint32_t a = 0; a < good.size(); ++a)
    for (uint32_t end = 0; end < 2; ++end) {
      if (good[a].end[end].kind != MapVertexKind::t) continue;
      // The whole circle on which it lands is seen from 1e-5 behind it on only.
      linked.arcs = good;
      for (MapArc &arc : linked.arcs) {
        if (arc.body != good[a].end[end].body || !arc.closed) continue;
        linked.arcs = good;
        linked.arcs.erase(linked.arcs.begin() + (&arc - linked.arcs.data()));
        break;
      }
      EXPECT_FALSE(linked.link());
    }
}

}  // namespace
