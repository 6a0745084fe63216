#include "maps/map_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "built_map.hpp"
#include "maps/edge_geometry.hpp"
#include "random_balls.hpp"

namespace {

// Areas of the faces of an owner, ascending; oracle::no_ball for bounded faces that show the background.
std::vector<double> areas_of(const BuiltMap &built, uint32_t owner) {
  std::vector<double> areas;
  for (uint32_t f = 1; f < built.map().faces.size(); ++f)
    if (built.caller(built.map().faces[f].owner) == owner) areas.push_back(built.map().faces[f].area);
  std::sort(areas.begin(), areas.end());
  return areas;
}
uint32_t loops_of(const BuiltMap &built, uint32_t face) {
  uint32_t count = 0;
  for (uint32_t l = built.map().faces[face].first_loop; l != hsp::no_id; l = built.map().loops[l].next_of_face) ++count;
  return count;
}

TEST(MapFaces, OfNothing) {
  const BuiltMap built(oracle::Balls{});
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_EQ(built.map().faces.size(), 1U);
  EXPECT_EQ(built.map().components, 0U);
}

TEST(MapFaces, HaveAsManyHolesAsThereArePartsOfTheEdges) {
  BuiltMap built(oracle::Balls{});
  hsp::VisibilityMap &map = built.builder().arrays();
  EXPECT_TRUE(hsp::add_holes(map));
  map.components = 1;
  EXPECT_FALSE(hsp::add_holes(map));
}

TEST(MapFaces, OfDiscsInFrontOfEachOther) {
  const BuiltMap built({{0, 0, 0, 50}, {10, 5, 100, 20}, {12, 5, 200, 5}, {200, 0, 0, 30}});
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_EQ(built.map().faces.size(), 5U);
  EXPECT_EQ(built.map().components, 4U);
  EXPECT_EQ(loops_of(built, 0), 2U);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(areas_of(built, 0)[0], pi * (2500 - 400), 1e-9);
  EXPECT_NEAR(areas_of(built, 1)[0], pi * (400 - 25), 1e-9);
  EXPECT_NEAR(areas_of(built, 2)[0], pi * 25, 1e-9);
  EXPECT_NEAR(areas_of(built, 3)[0], pi * 900, 1e-9);
}

// Six discs in a ring around a hole, with a ball seen through it: far behind, or small and apart.
TEST(MapFaces, SeenThroughAHole) {
  oracle::Balls ring;
  for (int k = 0; k < 6; ++k)
    ring.push_back({std::lround(1000 * std::cos(k * std::numbers::pi / 3)),
                    std::lround(1000 * std::sin(k * std::numbers::pi / 3)), 7 * k, 550});
  const BuiltMap empty(ring);
  ASSERT_EQ(empty.status(), hsp::Status::ok);
  const std::vector<double> hole = areas_of(empty, oracle::no_ball);
  ASSERT_EQ(hole.size(), 1U);
  oracle::Balls filled = ring;
  filled.push_back({3, 4, 0, 40});
  filled.push_back({100, 40, 0, 20});
  const BuiltMap two(filled);
  ASSERT_EQ(two.status(), hsp::Status::ok);
  const std::vector<double> rest = areas_of(two, oracle::no_ball);
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_NEAR(rest[0], hole[0] - std::numbers::pi * (1600 + 400), 1e-6);
  EXPECT_EQ(loops_of(two, 0), 1U);
  EXPECT_EQ(two.map().components, 3U);
}

// A ball cut into faces by nearer ones, with a hole in only one of them.
TEST(MapFaces, HolesBelongToTheFaceAroundThem) {
  oracle::Balls set = {{0, 0, 0, 1000}};
  for (int k = -3; k <= 3; ++k) set.push_back({3, 310 * k, 3000 + k, 200});  // a band across the disc
  set.push_back({500, 11, 2000, 90});
  set.push_back({-480, 300, 2000, 50});
  set.push_back({-490, -300, 2000, 60});
  const BuiltMap built(set);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  uint32_t with[4] = {};
  for (uint32_t f = 1; f < built.map().faces.size(); ++f)
    if (built.caller(built.map().faces[f].owner) == 0) ++with[loops_of(built, f)];
  EXPECT_EQ(with[2], 1U);
  EXPECT_EQ(with[3], 1U);
  EXPECT_EQ(areas_of(built, 0).size(), 2U);
}

TEST(MapFaces, RefusesEdgesThatDoNotFit) {
  oracle::RandomSource random(14);
  const oracle::Balls set = oracle::loose_balls(random, 60);
  BuiltMap built(set, {1, 2, 3});
  ASSERT_EQ(built.status(), hsp::Status::ok);
  hsp::VisibilityMap &map = built.builder().arrays();
  CarvedMemory memory;
  hsp::MapFaceFinder<hsp::BallScene> finder;
  memory.carve(finder, hsp::MapSizes{60, 60, map.edges.capacity()});
  const auto again = [&] {
    map.loops.clear();
    map.faces.clear();
    for (hsp::MapHalfEdge &half_edge : map.half_edges.items()) half_edge.loop = hsp::no_id;
    hsp::Patience endless;
    return finder.find(built.builder().discs(), hsp::MapTrust::all_arcs, map, endless);
  };
  ASSERT_TRUE(again());
  for (uint32_t h = 0; h < map.half_edges.size(); h += 3) {
    const uint32_t next = map.half_edges[h].next;
    map.half_edges[h].next = (h + 8) % map.half_edges.size();
    const bool same = map.half_edges[h].next == next;
    EXPECT_EQ(again(), same) << h;
    map.half_edges[h].next = next;
  }
  // Labels of another ball, unless they are the only ones of their loop.
  uint32_t noticed = 0, changed = 0;
  for (uint32_t e = 0; e < map.edges.size(); ++e) {
    hsp::MapEdge &edge = map.edges[e];
    const hsp::MapEdge good = edge;
    if (!edge.is_silhouette()) continue;
    edge.body = (edge.body + 1) % map.scene.balls.size();
    ++changed;
    noticed += again() ? 0 : 1;
    edge = good;
  }
  EXPECT_GT(2 * noticed, changed);
  EXPECT_GT(changed, 20U);
  ASSERT_TRUE(again());
}

// A ball of which nothing is drawn although its highest point is seen.
TEST(MapFaces, RefusesBallsThatWereForgotten) {
  BuiltMap one(oracle::Balls{{0, 0, 0, 50}});
  const BuiltMap two({{0, 0, 0, 50}, {200, 0, 0, 20}});
  hsp::VisibilityMap &map = one.builder().arrays();
  CarvedMemory memory;
  hsp::MapFaceFinder<hsp::BallScene> finder;
  memory.carve(finder, hsp::MapSizes{2, 2, map.edges.capacity()});
  const auto again = [&](const BuiltMap &of) {
    map.scene.balls = of.map().scene.balls;
    map.loops.clear();
    map.faces.clear();
    for (hsp::MapHalfEdge &half_edge : map.half_edges.items()) half_edge.loop = hsp::no_id;
    hsp::Patience endless;
    return finder.find(of.discs(), hsp::MapTrust::all_arcs, map, endless);
  };
  EXPECT_TRUE(again(one));
  EXPECT_FALSE(again(two));
}

}  // namespace
