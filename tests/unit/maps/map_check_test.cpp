// Each invariant notices records that break it.
#include "maps/map_check.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "built_map.hpp"
#include "random_balls.hpp"

namespace {

using hsp::MapInvariant;
using hsp::VisibilityMap;

class MapCheck : public testing::Test {
 protected:
  MapCheck() : random_(19), built_(oracle::loose_balls(random_, 60), {1, 2, 3}) {}

  MapInvariant violated() { return hsp::check_map(map(), built_.builder().scratch()).invariant; }
  VisibilityMap &map() { return built_.builder().arrays(); }
  // Breaks each record of an array in turn; `expected` must be what is found, and nothing after it is mended.
  template <class Record>
  void expect(hsp::FixedVector<Record> &records, MapInvariant expected, const std::function<void(Record &)> &spoil) {
    ASSERT_EQ(violated(), MapInvariant::none);
    for (uint32_t k = 0; k < records.size(); ++k) {
      const Record good = records[k];
      spoil(records[k]);
      EXPECT_EQ(violated(), expected) << "record " << k;
      records[k] = good;
    }
    ASSERT_EQ(violated(), MapInvariant::none);
  }

 private:
  oracle::RandomSource random_;
  BuiltMap built_;
};

TEST_F(MapCheck, Vertices) {
  expect<hsp::MapVertex>(map().vertices, MapInvariant::vertices, [&](hsp::MapVertex &v) {
    const bool three = v.kind == hsp::MapVertexKind::triple || v.kind == hsp::MapVertexKind::t;
    v.kind = three ? hsp::MapVertexKind::tangency : hsp::MapVertexKind::t;
  });
  expect<hsp::MapVertex>(map().vertices, MapInvariant::vertices, [](hsp::MapVertex &v) {
    v.leaving = v.kind == hsp::MapVertexKind::plain ? hsp::no_id : v.leaving ^ 1U;
  });
  expect<hsp::MapVertex>(map().vertices, MapInvariant::vertices,
                         [&](hsp::MapVertex &v) { v.body[0] = map().scene.balls.size(); });
  expect<hsp::MapEdge>(map().edges, MapInvariant::vertices,
                       [&](hsp::MapEdge &e) { e.vertex[0] = map().vertices.size(); });
}

TEST_F(MapCheck, Edges) {
  expect<hsp::MapEdge>(map().edges, MapInvariant::edges, [](hsp::MapEdge &e) { std::swap(e.from, e.to); });
  expect<hsp::MapEdge>(map().edges, MapInvariant::edges, [](hsp::MapEdge &e) { e.to += 7; });
  expect<hsp::MapEdge>(map().edges, MapInvariant::edges, [&](hsp::MapEdge &e) { e.body = map().scene.balls.size(); });
  expect<hsp::MapVertex>(map().vertices, MapInvariant::edges, [](hsp::MapVertex &v) {
    v.body[0] = 0;
    v.body[1] = v.body[2] = hsp::no_id;
  });
}

TEST_F(MapCheck, Successors) {
  expect<hsp::MapHalfEdge>(map().half_edges, MapInvariant::successors,
                           [&](hsp::MapHalfEdge &h) { h.next = (h.next + 1) % map().half_edges.size(); });
}

TEST_F(MapCheck, Loops) {
  expect<hsp::MapHalfEdge>(map().half_edges, MapInvariant::loops,
                           [&](hsp::MapHalfEdge &h) { h.loop = (h.loop + 1) % map().loops.size(); });
  expect<hsp::MapLoop>(map().loops, MapInvariant::loops, [](hsp::MapLoop &l) { l.first_half_edge ^= 1U; });
  // Loops of silhouettes alone may have any owner, as far as labels tell.
  uint32_t noticed = 0;
  for (uint32_t l = 0; l < map().loops.size(); ++l) {
    const hsp::MapLoop good = map().loops[l];
    map().loops[l].owner = good.owner == 0 ? 1 : 0;
    noticed += violated() == MapInvariant::loops;
    EXPECT_NE(violated(), MapInvariant::none);
    map().loops[l] = good;
  }
  EXPECT_GT(noticed, map().loops.size() / 2);
}

TEST_F(MapCheck, Faces) {
  expect<hsp::MapFace>(map().faces, MapInvariant::faces,
                       [&](hsp::MapFace &f) { f.owner = f.owner == hsp::no_id ? 0 : hsp::no_id; });
  expect<hsp::MapFace>(map().faces, MapInvariant::faces, [](hsp::MapFace &f) { f.first_loop = hsp::no_id; });
  expect<hsp::MapLoop>(map().loops, MapInvariant::faces, [](hsp::MapLoop &l) { l.face ^= 1U; });
  expect<hsp::MapLoop>(map().loops, MapInvariant::faces, [](hsp::MapLoop &l) { l.area = -l.area; });
  expect<hsp::MapLoop>(map().loops, MapInvariant::faces, [](hsp::MapLoop &l) { l.next_of_face = l.next_of_face == 0; });
}

// Faces with other numbers, though all else follows them.
TEST_F(MapCheck, FacesOfOneOwnerFollowEachOther) {
  const uint32_t n = map().faces.size();
  const auto exchange = [&](uint32_t f, uint32_t g) {
    std::swap(map().faces[f], map().faces[g]);
    for (hsp::MapLoop &loop : map().loops.items()) loop.face = loop.face == f ? g : loop.face == g ? f : loop.face;
  };
  uint32_t noticed = 0;
  for (uint32_t f = 1; f + 1 < n; ++f) {
    const bool alike = map().faces[f].owner == map().faces[f + 1].owner;
    exchange(f, f + 1);
    EXPECT_EQ(violated(), alike ? MapInvariant::none : MapInvariant::faces) << f;
    noticed += alike ? 0 : 1;
    exchange(f, f + 1);
  }
  EXPECT_GT(noticed, 10U);
  EXPECT_EQ(violated(), MapInvariant::none);
}

TEST_F(MapCheck, Euler) {
  ++map().components;
  EXPECT_EQ(violated(), MapInvariant::euler);
}

TEST_F(MapCheck, Positions) {
  double largest = 0;
  for (const hsp::SeenBall &ball : map().scene.balls) largest = std::max(largest, ball.r);
  expect<hsp::MapVertex>(map().vertices, MapInvariant::positions, [&](hsp::MapVertex &v) { v.x += 1e-4 * largest; });
  expect<hsp::MapVertex>(map().vertices, MapInvariant::positions, [&](hsp::MapVertex &v) { v.y -= 1e-4 * largest; });
}

TEST_F(MapCheck, Areas) {
  for (uint32_t f = 1; f < map().faces.size(); ++f) {
    map().faces[f].area *= 1 + 1e-6;
    EXPECT_EQ(violated(), MapInvariant::areas);
    map().faces[f].area /= 1 + 1e-6;
  }
  hsp::MapLoop &outline = map().loops[map().faces[0].first_loop];
  outline.area *= 1.001;
  EXPECT_EQ(violated(), MapInvariant::areas);
}

// Two discs beside each other, and what becomes of their map if what runs around one is taken for a hole in the other.
class TwoDiscs {
 public:
  TwoDiscs(int64_t one, int64_t other) : built_({{0, 0, 0, one}, {one + other + 10, 0, 0, other}}) {
    for (uint32_t l = 0; l < map().loops.size(); ++l) {
      const hsp::MapLoop &loop = map().loops[l];
      const bool large = map().scene.balls[map().edges[loop.first_half_edge / 2].body].x < 0;
      (loop.area > 0 ? outer_ : hole_)[large ? 0 : 1] = l;
    }
  }
  hsp::VisibilityMap &map() { return built_.builder().arrays(); }
  MapInvariant violated() { return hsp::check_map(map(), built_.builder().scratch()).invariant; }
  // The hole around disc k into the face of the other one.
  void put_into_other(int k) {
    hsp::MapLoop &hole = map().loops[hole_[k]];
    hsp::MapLoop &outer = map().loops[outer_[1 - k]];
    hsp::MapFace &background = map().faces[0];
    if (background.first_loop == hole_[k]) {
      background.first_loop = hole.next_of_face;
    } else {
      map().loops[background.first_loop].next_of_face = hole.next_of_face;
    }
    hole.face = outer.face;
    hole.owner = outer.owner;
    hole.next_of_face = hsp::no_id;
    outer.next_of_face = hole_[k];
    map().faces[outer.face].area += hole.area;
  }

 private:
  BuiltMap built_;
  uint32_t outer_[2] = {}, hole_[2] = {};
};

TEST(MapCheckOfWrongMaps, MoreOrLessIsSeenOfABallThanItsDisc) {
  for (const int64_t other : {49, 30, 10}) {
    TwoDiscs discs(other, 50);
    ASSERT_EQ(discs.violated(), MapInvariant::none);
    discs.put_into_other(1);
    EXPECT_EQ(discs.violated(), MapInvariant::areas) << other;
  }
  TwoDiscs discs(40, 50);
  discs.map().faces[1].area += 1e4;
  discs.map().faces[2].area -= 1e4;
  for (int f = 1; f <= 2; ++f) discs.map().loops[discs.map().faces[f].first_loop].area += f == 1 ? 1e4 : -1e4;
  EXPECT_NE(discs.violated(), MapInvariant::none);
}

TEST(MapCheckOfWrongMaps, ABallIsSeenBesideItsDisc) {
  for (const int64_t other : {50, 51, 300}) {
    TwoDiscs discs(other, 50);
    discs.put_into_other(1);
    EXPECT_EQ(discs.violated(), MapInvariant::sides) << other;
  }
}

TEST(MapCheckOfWrongMaps, TheBackgroundHasNoEdges) {
  for (const int64_t other : {10, 50, 300}) {
    TwoDiscs discs(other, 50);
    discs.put_into_other(0);
    discs.put_into_other(1);
    EXPECT_EQ(discs.violated(), MapInvariant::faces) << other;
  }
}

// A silhouette in front of a ball that is put behind its front.
TEST(MapCheckOfWrongMaps, ASilhouetteIsSeenBehindABall) {
  BuiltMap built({{0, 0, 0, 50}, {10, 0, 100, 20}});
  hsp::VisibilityMap &map = built.builder().arrays();
  const auto violated = [&] { return hsp::check_map(map, built.builder().scratch()).invariant; };
  ASSERT_EQ(violated(), MapInvariant::none);
  std::vector<hsp::SeenBall> balls(map.scene.balls.begin(), map.scene.balls.end());
  map.scene.balls = hsp::Span<const hsp::SeenBall>(balls.data(), 2);
  balls[0].z -= 60;
  EXPECT_EQ(violated(), MapInvariant::none);
  balls[0].z -= 40;
  EXPECT_EQ(violated(), MapInvariant::sides);
}

}  // namespace
