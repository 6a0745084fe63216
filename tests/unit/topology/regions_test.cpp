// The simple face where the scan of an outer shell starts holds the highest point of its component; which balls line a
// region.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "built_topology.hpp"
#include "random_balls.hpp"

namespace {

using hsp::CutArc;
using hsp::Topology;
using oracle::Balls;

struct Seen {
  int vertices = 0, on_arcs = 0, inside = 0;
};

std::vector<uint32_t> ring_of(const Topology &topology, uint32_t face) {
  std::vector<uint32_t> ring;
  uint32_t at = topology.faces[face].q;
  do {
    ring.push_back(at);
    at = topology.quads.lnext(at);
  } while (at != topology.faces[face].q && ring.size() <= 4 * topology.quads.edges);
  return ring;
}

// Of the highest point of a ball: a vertex, or a point of an edge, or inside a face that is not cut there.
void check_start(BuiltTopology &built, uint32_t face, uint32_t top_ball, Seen &seen) {
  const Topology &topology = built.structure();
  ASSERT_EQ(topology.ball_of(built.boundary(), face), top_ball);
  const std::vector<uint32_t> ring = ring_of(topology, face);
  for (uint32_t v = topology.first_pole; v < topology.vertex_count; ++v) {
    if (topology.pole_at(v).ball() != top_ball || topology.pole_at(v).is_lowest()) continue;
    ASSERT_TRUE(std::any_of(ring.begin(), ring.end(), [&](uint32_t q) { return topology.quads.origin(q) == v; }));
    ++seen.vertices;
    return;
  }
  bool cut_there = false;
  for (uint32_t k = 0; k < topology.cut_arcs.size(); ++k) {
    const CutArc &arc = topology.cut_arcs[k];
    if (arc.ball != top_ball || (arc.poles & CutArc::passes_north) == 0) continue;
    cut_there = true;
    // Without a vertex at the top there is none at the other pole: every circle that passes one passes both.
    ASSERT_EQ(arc.pieces(), 1U);
    const uint32_t q = hsp::quarter_edge(topology.cut_first_edge[k]);
    ASSERT_TRUE(topology.quads.left(q) == face || topology.quads.left(hsp::sym(q)) == face);
    ++seen.on_arcs;
  }
  if (cut_there) return;
  // The face that holds the top is not cut at all.
  for (uint32_t other = 0; other < topology.face_count; ++other) {
    ASSERT_EQ(topology.faces[other].face == topology.faces[face].face, other == face);
  }
  ++seen.inside;
}

void check(const Balls &balls, Seen &seen) {
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const Topology &topology = built.structure();
  int64_t highest = INT64_MIN;
  for (uint32_t c = 0; c < topology.component_count; ++c) {
    const hsp::ComponentRecord &component = topology.components[c];
    const uint32_t start = topology.shells[component.outer_shell].start_face;
    ASSERT_NO_FATAL_FAILURE(check_start(built, start, component.top_ball, seen)) << oracle::to_text(balls);
    const hsp::exact::LatticeBall top = built.balls().ball(component.top_ball);
    highest = std::max(highest, top.centre.z + top.radius);
  }
  if (topology.start_face == hsp::no_id) return;
  // The start of all is on a ball that reaches as high as any.
  const hsp::exact::LatticeBall top = built.balls().ball(topology.ball_of(built.boundary(), topology.start_face));
  ASSERT_EQ(top.centre.z + top.radius, highest) << oracle::to_text(balls);
}

TEST(StartFaces, HoldTheHighestPointOfSetsOfAllKinds) {
  oracle::RandomSource random(1);
  Seen seen;
  for (int k = 0; k < 400; ++k) {
    ASSERT_NO_FATAL_FAILURE(check(oracle::any_balls(random, static_cast<std::size_t>(random.in(1, 25))), seen));
  }
  EXPECT_GT(seen.vertices, 20);
  EXPECT_GT(seen.inside, 100);
}

// Bumps that leave both poles of the large ball free: great circles through both, in either order.
TEST(StartFaces, HoldTheHighestPointOfBallsWithBumps) {
  oracle::RandomSource random(2);
  Seen seen;
  for (int k = 0; k < 500; ++k) {
    // Around points of integer length, so that several lie in one upright plane.
    Balls balls = {{0, 0, 0, 1500}};
    const std::int64_t n = random.in(2, 6);
    for (std::int64_t j = 0; j < n; ++j) {
      const std::int64_t slopes[][2] = {{0, 1500}, {1500, 0}, {900, 1200}, {1200, 900}};
      const auto &slope = slopes[random.in(0, 3)];
      const std::int64_t up = random.one_in(2) ? slope[1] : -slope[1];
      const std::int64_t along = slope[0] / 5;
      const std::int64_t x = random.one_in(2) ? 3 * along : -4 * along;
      const std::int64_t y = random.one_in(2) ? 4 * along : x > 0 ? -4 * along : 3 * along;
      balls.push_back({x, y, up, random.in(20, 300)});
    }
    ASSERT_NO_FATAL_FAILURE(check(balls, seen));
  }
  EXPECT_GT(seen.vertices, 100);
  EXPECT_GT(seen.on_arcs, 50);
  EXPECT_GT(seen.inside, 50);
}

std::vector<uint32_t> balls_of_region(BuiltTopology &built, uint32_t region) {
  const uint32_t count = hsp::count_balls_of_region(built.boundary(), built.structure(), region);
  std::vector<uint32_t> ids(count + 1, 12345);
  hsp::list_balls_of_region(built.balls(), built.boundary(), built.structure(), region, {ids.data(), count});
  EXPECT_EQ(ids.back(), 12345U);
  ids.pop_back();
  return ids;
}

// Two cages of six balls that share one, which has faces on three regions and several on the outer one; a ball in the
// first, one buried in the wall, one far away.
TEST(RegionBalls, OfTwoCages) {
  const Balls balls = {{1000, 0, 0, 850},    {0, 1000, 0, 850},     {0, -1000, 0, 850},   {0, 0, 1000, 850},
                       {0, 0, -1000, 850},   {-1000, 0, 0, 850},    {0, 0, 0, 50},        {3000, 0, 0, 850},
                       {2000, 1000, 0, 850}, {2000, -1000, 0, 850}, {2000, 0, 1000, 850}, {2000, 0, -1000, 850},
                       {990, 0, 0, 100},     {9000, 0, 0, 850}};
  oracle::RandomSource random(3);
  for (int k = 0; k < 40; ++k) {
    const std::vector<uint32_t> order = random.permutation(balls.size());
    BuiltTopology built(oracle::permuted(balls, order));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    ASSERT_EQ(built.structure().region_count, 3U);
    const auto named = [&](const std::vector<uint32_t> &members) {
      std::vector<uint32_t> ids;
      for (uint32_t place = 0; place < balls.size(); ++place)
        if (std::find(members.begin(), members.end(), order[place]) != members.end()) ids.push_back(place);
      return ids;
    };
    EXPECT_EQ(balls_of_region(built, 0), named({0, 1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 13}));
    const std::vector<uint32_t> first = named({0, 1, 2, 3, 4, 5, 6}), second = named({0, 7, 8, 9, 10, 11});
    const bool in_order = balls_of_region(built, 1) == first;
    EXPECT_EQ(balls_of_region(built, 1), in_order ? first : second);
    EXPECT_EQ(balls_of_region(built, 2), in_order ? second : first);
  }
}

// A ball is listed once for every region that any of its faces is on.
TEST(RegionBalls, OfSetsOfAllKinds) {
  oracle::RandomSource random(4);
  for (int k = 0; k < 300; ++k) {
    BuiltTopology built(oracle::any_balls(random, static_cast<std::size_t>(random.in(0, 25))));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    std::vector<std::set<uint32_t>> expected(built.structure().region_count);
    for (uint32_t f = 0; f < built.boundary().face_count(); ++f) {
      const hsp::FaceRecord &face = built.boundary().face(f);
      expected[built.structure().shells[face.shell].region].insert(built.balls().caller[face.ball]);
    }
    for (uint32_t region = 0; region < expected.size(); ++region)
      ASSERT_EQ(balls_of_region(built, region),
                std::vector<uint32_t>(expected[region].begin(), expected[region].end()));
  }
}

}  // namespace
