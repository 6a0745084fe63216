#include "maps/map_queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "built_map.hpp"
#include "maps/edge_geometry.hpp"
#include "random_balls.hpp"

namespace {

// The front of the highest ball, of all that the map knows.
double highest_front(const hsp::VisibilityMap &map, double x, double y) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const hsp::SeenBall &ball : map.scene.balls) {
    const double squared = ball.r * ball.r - (x - ball.x) * (x - ball.x) - (y - ball.y) * (y - ball.y);
    if (squared > 0) highest = std::max(highest, ball.z + std::sqrt(squared));
  }
  return highest;
}

uint32_t face_at(const BuiltMap &built, double x, double y) {
  return hsp::face_at(built.map(), hsp::sight_at(built.map(), built.discs(), x, y).ball, x, y);
}

// Faces by areas: so many of random points are in each.
TEST(MapQueries, FindFacesAsOftenAsTheirAreasSay) {
  oracle::RandomSource random(20);
  const oracle::Balls balls = oracle::loose_balls(random, 30);
  const BuiltMap built(balls, {1, 2, 3});
  const hsp::VisibilityMap &map = built.map();
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const oracle::PixelGrid grid = oracle::grid_around(built.seen(), 300);
  std::vector<double> counted(map.faces.size(), 0), border(map.faces.size(), 0);
  for (size_t row = 0; row < grid.rows; ++row)
    for (size_t column = 0; column < grid.columns; ++column) {
      const double x = grid.x(column);
      const double y = grid.y(row);
      const uint32_t face = face_at(built, x, y);
      ASSERT_LT(face, map.faces.size());
      counted[face] += grid.side * grid.side;
      const hsp::MapSight sight = hsp::sight_at(map, built.discs(), x, y);
      ASSERT_EQ(sight.ball, map.faces[face].owner);
      ASSERT_EQ(sight.depth, highest_front(map, x, y));
    }
  for (uint32_t h = 0; h < map.half_edges.size(); ++h) {
    const hsp::MapEdge &edge = map.edges[h / 2];
    border[map.face_of(h)] += (edge.to - edge.from) * map.scene.balls[edge.body].r;
  }
  for (uint32_t f = 1; f < map.faces.size(); ++f)
    EXPECT_NEAR(counted[f], map.faces[f].area, grid.side * border[f] + 4 * grid.side * grid.side) << f;
}

// The same ball within a ring of others and around it: two faces, one in the hole of the other.
TEST(MapQueries, FindFacesWithinHoles) {
  oracle::Balls balls = {{0, 0, 0, 3000}};
  for (int k = 0; k < 6; ++k)
    balls.push_back({std::lround(1000 * std::cos(k * 3.14159265358979 / 3)),
                     std::lround(1000 * std::sin(k * 3.14159265358979 / 3)), 9000 + 7 * k, 550});
  const BuiltMap built(balls);
  const hsp::VisibilityMap &map = built.map();
  const hsp::SeenBall &large = map.scene.balls[map.scene.balls.size() - 1];
  ASSERT_EQ(large.r, 3000);
  const uint32_t inner = face_at(built, large.x + 3, large.y + 4);
  const uint32_t outer = face_at(built, large.x + 3, large.y + 2500);
  ASSERT_LT(inner, map.faces.size());
  ASSERT_LT(outer, map.faces.size());
  EXPECT_LT(map.faces[inner].area, map.faces[outer].area);
  EXPECT_EQ(map.faces[inner].owner, map.faces[outer].owner);
  EXPECT_EQ(face_at(built, large.x + 3001, large.y), 0U);
}

// Points at the height of vertices to their left and right, in a scene that is symmetric about all its axes.
TEST(MapQueries, FindFacesAtTheHeightOfVertices) {
  const BuiltMap built({{-40, 0, 0, 60}, {40, 0, 0, 60}, {0, 300, 0, 60}, {0, -300, 0, 60}, {0, 0, -10, 80}});
  const hsp::VisibilityMap &map = built.map();
  ASSERT_EQ(built.status(), hsp::Status::ok);
  int asked = 0;
  for (const hsp::MapVertex &vertex : map.vertices.items()) {
    for (int k = -100; k <= 100; ++k) {
      const double x = 1.07 * k;
      if (std::abs(x - vertex.x) < 1e-3) continue;
      for (const double y : {vertex.y, -vertex.y, 0.0}) {
        const hsp::MapSight sight = hsp::sight_at(map, built.discs(), x, y);
        const uint32_t face = hsp::face_at(map, sight.ball, x, y);
        ASSERT_LT(face, map.faces.size()) << x << ' ' << y;
        EXPECT_EQ(map.faces[face].owner, sight.ball);
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 1000);
}

TEST(MapQueries, TellDepthAndGapAlongEdges) {
  oracle::RandomSource random(21);
  int edges = 0, gaps = 0, outlines = 0, creases = 0;
  for (int time = 0; time < 20; ++time) {
    const BuiltMap built(oracle::loose_balls(random, 60), {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    for (uint32_t e = 0; e < map.edges.size(); ++e) {
      const hsp::MapEdge &edge = map.edges[e];
      if (edge.to - edge.from < 1e-3) continue;
      const auto at = [&](double part) { return hsp::edge_point(map, e, edge.from + part * (edge.to - edge.from)); };
      const hsp::EdgePoint p = at(0.4);
      const hsp::EdgePoint next = at(0.4001);
      // A small step to the right of the direction of travel.
      const double length = std::hypot(next.x - p.x, next.y - p.y);
      const double step = 1e-9 * map.scene.balls[edge.body].r;
      const double x = p.x + step * (next.y - p.y) / length;
      const double y = p.y - step * (next.x - p.x) / length;
      const double right = highest_front(map, x, y);
      const double left = highest_front(map, 2 * p.x - x, 2 * p.y - y);
      const double tolerance = 1e-3 * map.scene.balls[edge.body].r;
      ++edges;
      EXPECT_NEAR(left, p.z - p.gap_left, tolerance);
      if (std::isinf(p.gap_right)) {
        EXPECT_TRUE(std::isinf(right));
        ++outlines;
      } else {
        EXPECT_NEAR(right, p.z - p.gap_right, tolerance);
        gaps += p.gap_right > tolerance;
      }
      creases += edge.is_silhouette() ? 0 : 1;
    }
  }
  EXPECT_GT(edges, 1000);
  EXPECT_GT(gaps, 300);
  EXPECT_GT(outlines, 300);
  EXPECT_GT(creases, 300);
}

TEST(MapQueries, SumAreasByBalls) {
  oracle::RandomSource random(22);
  const BuiltMap built(oracle::loose_balls(random, 60), {1, 2, 3});
  const hsp::VisibilityMap &map = built.map();
  const uint32_t n = built.grid().balls().n;
  std::vector<double> area(n, 7), expected(n, 0);
  hsp::sum_visible_areas(map, [&](uint32_t ball) { return built.caller(ball); }, {area.data(), n});
  double all = 0;
  for (const hsp::MapFace &face : map.faces.items())
    if (face.owner != hsp::no_id) {
      expected[built.caller(face.owner)] += face.area;
      all += face.area;
    }
  EXPECT_EQ(area, expected);
  EXPECT_EQ(hsp::covered_area(map), all);
  EXPECT_EQ(map.owners, n - static_cast<uint32_t>(std::count(expected.begin(), expected.end(), 0.0)));
}

TEST(MapQueries, StepBackAndFromLoopToLoop) {
  oracle::RandomSource random(23);
  uint32_t holes = 0;
  for (int time = 0; time < 10; ++time) {
    const BuiltMap built(oracle::loose_balls(random, 60), {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    for (uint32_t h = 0; h < map.half_edges.size(); ++h)
      EXPECT_EQ(hsp::previous_half_edge(map, map.half_edges[h].next), h);
    std::vector<int> reached(map.loops.size(), 0);
    for (uint32_t f = 0; f < map.faces.size(); ++f) {
      uint32_t loop = map.faces[f].first_loop;
      do {
        EXPECT_EQ(map.loops[loop].face, f);
        ++reached[loop];
        holes += f != 0 && map.loops[loop].area < 0;
        loop = hsp::next_loop(map, loop);
      } while (loop != map.faces[f].first_loop);
    }
    EXPECT_EQ(std::count(reached.begin(), reached.end(), 1), static_cast<std::ptrdiff_t>(map.loops.size()));
  }
  EXPECT_GT(holes, 0U);
}

TEST(MapQueries, SeeNothingFarOut) {
  const BuiltMap built({{0, 0, 0, 5}, {6, 0, 0, 5}});
  for (const double far : {1e9, -1e9, 0x1p52, 1e18, -1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(hsp::sight_at(built.map(), built.discs(), far, 0).ball, hsp::no_id);
    EXPECT_EQ(hsp::sight_at(built.map(), built.discs(), 0, far).ball, hsp::no_id);
    EXPECT_EQ(face_at(built, far, far), 0U);
  }
}

}  // namespace
