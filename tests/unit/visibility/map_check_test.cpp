// Each invariant notices records that break it.
#include "visibility/map_check.hpp"

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
                         [&](hsp::MapVertex &v) { v.ball[0] = map().balls.size(); });
  expect<hsp::MapEdge>(map().edges, MapInvariant::vertices,
                       [&](hsp::MapEdge &e) { e.vertex[0] = map().vertices.size(); });
}

TEST_F(MapCheck, Edges) {
  expect<hsp::MapEdge>(map().edges, MapInvariant::edges, [](hsp::MapEdge &e) { std::swap(e.from, e.to); });
  expect<hsp::MapEdge>(map().edges, MapInvariant::edges, [](hsp::MapEdge &e) { e.to += 7; });
  expect<hsp::MapEdge>(map().edges, MapInvariant::edges, [&](hsp::MapEdge &e) { e.ball = map().balls.size(); });
  expect<hsp::MapVertex>(map().vertices, MapInvariant::edges, [](hsp::MapVertex &v) {
    v.ball[0] = 0;
    v.ball[1] = v.ball[2] = hsp::no_id;
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
  for (const hsp::SeenBall &ball : map().balls) largest = std::max(largest, ball.r);
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

}  // namespace
