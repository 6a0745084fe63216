// Maps as paths: every side of an edge once, lines once, loops closed, areas by the arcs' own equations.
#include "maps/map_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "built_map.hpp"
#include "random_balls.hpp"

namespace {

using Point = std::array<double, 2>;

Point at(const hsp::ProjectedArc &arc, double t) {
  const auto along = [&](size_t k) {
    return arc.ellipse.centre[k] + std::cos(t) * arc.ellipse.major[k] + std::sin(t) * arc.ellipse.minor[k];
  };
  return {along(0), along(1)};
}

double distance(const Point &p, const double (&q)[2]) {
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

// Twice the area that an arc sweeps about the origin.
double swept_twice(const hsp::ProjectedArc &arc) {
  const hsp::ProjectedEllipse &e = arc.ellipse;
  return e.centre[0] * (arc.end[1] - arc.start[1]) - e.centre[1] * (arc.end[0] - arc.start[0]) +
         (e.major[0] * e.minor[1] - e.major[1] * e.minor[0]) * (arc.to - arc.from);
}

class MapPathsOf {
 public:
  explicit MapPathsOf(BuiltMap &built)
      : built_(built), paths_(built.grid().balls(), built.map(), built.builder().scratch()) {}
  const hsp::MapPaths &paths() const { return paths_; }
  const hsp::BallSet &balls() const { return built_.grid().balls(); }

 private:
  BuiltMap &built_;
  hsp::MapPaths paths_;
};

// The arcs of half-edges lie on both curves that they should lie on, with the owner's ellipse the right way round.
TEST(MapPaths, ArcsRunFromVertexToVertex) {
  oracle::RandomSource random(30);
  uint32_t creases = 0;
  for (int time = 0; time < 10; ++time) {
    const BuiltMap built(oracle::loose_balls(random, 60), {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    for (uint32_t h = 0; h < map.half_edges.size(); ++h) {
      const hsp::ProjectedArc arc = hsp::arc_of(map, h);
      const hsp::MapEdge &edge = map.edges[h / 2];
      const double near = 1e-6 * map.scene.balls[edge.body].r;
      EXPECT_LE(distance(at(arc, arc.from), arc.start), near);
      EXPECT_LE(distance(at(arc, arc.to), arc.end), near);
      EXPECT_EQ(arc.from <= arc.to, h % 2 == 0);
      EXPECT_EQ(arc.other_ball == hsp::no_id, edge.is_silhouette());
      const hsp::ProjectedEllipse &e = arc.ellipse;
      EXPECT_GE(std::hypot(e.major[0], e.major[1]), std::hypot(e.minor[0], e.minor[1]));
      EXPECT_GE(e.major[0] * e.minor[1] - e.major[1] * e.minor[0], 0);
      // The far ball's and the near ball's front are equally high along a crease.
      if (edge.is_silhouette()) continue;
      ++creases;
      const Point p = at(arc, arc.from + 0.3 * (arc.to - arc.from));
      const auto front = [&](const hsp::SeenBall &ball) {
        const double dx = p[0] - ball.x, dy = p[1] - ball.y;
        return ball.z + std::sqrt(std::max(0.0, ball.r * ball.r - dx * dx - dy * dy));
      };
      EXPECT_NEAR(front(map.scene.balls[edge.body]), front(map.scene.balls[edge.nearer]),
                  1e-3 * map.scene.balls[edge.body].r);
    }
  }
  EXPECT_GT(creases, 200U);
}

TEST(MapPaths, AreTheFacesOfEachBall) {
  oracle::RandomSource random(31);
  size_t holes = 0;
  for (int time = 0; time < 10; ++time) {
    BuiltMap built(oracle::loose_balls(random, 60), {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    const MapPathsOf of(built);
    const hsp::PaintedPaths paths = of.paths().paths();
    ASSERT_EQ(paths.size(), map.owners);
    ASSERT_TRUE(paths.have_own_lines());
    std::vector<double> area(of.balls().n, 0), expected(of.balls().n, 0);
    for (const hsp::MapFace &face : map.faces.items())
      if (face.owner != hsp::no_id) expected[map.scene.balls[face.owner].ball] += face.area;
    size_t arcs = 0;
    for (uint32_t p = 0; p < paths.size(); ++p) {
      const uint32_t ball = paths.ball_of(p);
      if (p > 0) {
        EXPECT_LE(map.frame.centre_of(of.balls(), paths.ball_of(p - 1)).z, map.frame.centre_of(of.balls(), ball).z);
      }
      double swept = 0, last[2] = {}, begin[2] = {};
      bool closed = true;
      paths.visit(of.balls(), p, hsp::PathPart::outline, [&](const hsp::ProjectedArc &arc, bool first, bool closes) {
        EXPECT_EQ(first, closed);
        if (first) std::copy(arc.start, arc.start + 2, begin);
        EXPECT_TRUE(first || std::equal(last, last + 2, arc.start));
        EXPECT_TRUE(!closes || std::equal(begin, begin + 2, arc.end));
        swept += swept_twice(arc);
        std::copy(arc.end, arc.end + 2, last);
        closed = closes;
        ++arcs;
      });
      EXPECT_TRUE(closed);
      EXPECT_EQ(area[ball], 0);  // no two paths of one ball
      area[ball] = 0.5 * swept;
    }
    size_t sides = 0;
    for (uint32_t h = 0; h < map.half_edges.size(); ++h) sides += map.faces[map.face_of(h)].owner != hsp::no_id;
    EXPECT_EQ(arcs, sides);
    for (const hsp::MapLoop &loop : map.loops.items()) holes += loop.owner != hsp::no_id && loop.area < 0;
    for (uint32_t i = 0; i < of.balls().n; ++i)
      EXPECT_NEAR(area[i], expected[i], 1e-9 * of.balls().r[i] * of.balls().r[i]) << i;
  }
  EXPECT_GT(holes, 0U);
}

// Lines of a ball: its own silhouette, and creases where it is the nearer one. Runs are as long as they can be.
TEST(MapPaths, DrawEveryEdgeOnce) {
  oracle::RandomSource random(32);
  size_t whole = 0, runs = 0;
  for (int time = 0; time < 10; ++time) {
    oracle::Balls balls = oracle::loose_balls(random, 40);
    balls.push_back({0, 0, 5000, 70});  // beside all others
    BuiltMap built(balls, {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    const MapPathsOf of(built);
    const hsp::PaintedPaths paths = of.paths().paths();
    size_t arcs = 0, begun = 0;
    double length = 0;
    for (uint32_t p = 0; p < paths.size(); ++p) {
      double last[2] = {}, begin[2] = {};
      bool ended = true;
      paths.visit(of.balls(), p, hsp::PathPart::lines, [&](const hsp::ProjectedArc &arc, bool first, bool closes) {
        EXPECT_TRUE(first || (!ended && std::equal(last, last + 2, arc.start)));
        if (first) std::copy(arc.start, arc.start + 2, begin);
        EXPECT_TRUE(!closes || std::equal(begin, begin + 2, arc.end));
        EXPECT_LE(arc.from, arc.to);
        std::copy(arc.end, arc.end + 2, last);
        ended = closes;
        whole += closes;
        begun += first;
        length += arc.to - arc.from;
        ++arcs;
      });
    }
    EXPECT_EQ(arcs, map.edges.size());
    double expected = 0;
    size_t starts = 0;
    for (uint32_t e = 0; e < map.edges.size(); ++e) expected += map.edges[e].to - map.edges[e].from;
    EXPECT_NEAR(length, expected, 1e-9 * expected);
    // A run begins behind a directed edge that runs against its curve, or is a loop without any.
    for (uint32_t h = 1; h < map.half_edges.size(); h += 2) starts += map.half_edges[h].next % 2 == 0;
    for (uint32_t l = 0; l < map.loops.size(); ++l) {
      const uint32_t first = map.loops[l].first_half_edge;
      bool own = true;
      uint32_t h = first;
      do {
        own &= h % 2 == 0;
        h = map.half_edges[h].next;
      } while (h != first);
      starts += own;
    }
    EXPECT_EQ(begun, starts);
    runs += begun;
  }
  EXPECT_GT(whole, 5U);
  EXPECT_GT(runs, 200U);
}

TEST(MapPaths, OfNothing) {
  BuiltMap built({});
  const MapPathsOf of(built);
  EXPECT_EQ(of.paths().size(), 0U);
  const hsp::ViewBox box = hsp::box_of(of.balls(), of.paths().paths());
  EXPECT_EQ(box.high[0], 0);
}

// As many faces as can be for the memory that there is: each a part of a ball between its neighbours.
TEST(MapPaths, FitTheScratchMemory) {
  for (const uint32_t count : {1U, 7U, 40U}) {
    oracle::Balls balls;
    for (uint32_t k = 0; k < count; ++k) balls.push_back({3000 * static_cast<int64_t>(k), 0, 0, 1000});
    BuiltMap built(balls);
    built.take({count, count, count});  // an edge each
    built.look({0, 0, 1});
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_EQ(built.map().edges.size(), count);
    EXPECT_EQ(MapPathsOf(built).paths().size(), count);
  }
}

}  // namespace
