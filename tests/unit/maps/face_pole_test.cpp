// Poles of faces against many points, and against faces of which they are known.
#include "maps/face_pole.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "built_map.hpp"
#include "maps/edge_geometry.hpp"
#include "maps/map_queries.hpp"
#include "random_balls.hpp"

namespace {

struct Point {
  double x, y;
};

// Points along all edges around a face, `count` for each.
std::vector<Point> outline(const hsp::VisibilityMap &map, uint32_t face, int count) {
  std::vector<Point> points;
  for (uint32_t h = 0; h < map.half_edges.size(); ++h) {
    if (map.face_of(h) != face) continue;
    const hsp::MapEdge &edge = map.edges[h / 2];
    const hsp::EdgeEllipse ellipse = map.scene.curve(edge, {}, {}).ellipse;
    for (int k = 0; k <= count; ++k) {
      const double t = edge.from + (edge.to - edge.from) * k / count;
      points.push_back({ellipse.centre[0] + std::cos(t) * ellipse.first[0] + std::sin(t) * ellipse.second[0],
                        ellipse.centre[1] + std::cos(t) * ellipse.first[1] + std::sin(t) * ellipse.second[1]});
    }
  }
  return points;
}

double distance_from(const std::vector<Point> &points, double x, double y) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point &p : points) nearest = std::min(nearest, std::hypot(p.x - x, p.y - y));
  return nearest;
}

bool is_in(const BuiltMap &built, uint32_t face, double x, double y) {
  const hsp::VisibilityMap &map = built.map();
  return hsp::sight_at(map, built.discs(), x, y).ball == map.faces[face].owner &&
         hsp::face_at(map, map.faces[face].owner, x, y) == face;
}

struct Seen {
  int faces = 0, loose = 0;
};

void check_pole(const BuiltMap &built, uint32_t face, oracle::RandomSource &random, Seen &seen) {
  const hsp::VisibilityMap &map = built.map();
  const hsp::FacePole pole = hsp::find_pole(map, face);
  const std::vector<Point> points = outline(map, face, 60);
  ++seen.faces;
  ASSERT_GT(pole.radius, 0.0) << face;
  ASSERT_GE(pole.bound, pole.radius);
  if (pole.bound > pole.radius * (1 + hsp::pole_tolerance)) ++seen.loose;
  EXPECT_TRUE(is_in(built, face, pole.x, pole.y)) << face;
  const double sampled = distance_from(points, pole.x, pole.y);
  EXPECT_LE(pole.radius, sampled * (1 + 1e-9)) << face;
  EXPECT_GE(pole.radius, 0.95 * sampled - 1e-3 * map.scene.balls[0].r) << face;
  // Nothing in the face is deeper than the bound, by so much as samples of the outline miss.
  Point low = points[0], high = points[0];
  for (const Point &p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double gap = 0;
  for (size_t k = 1; k < points.size(); ++k)
    if (k % 61 != 0) gap = std::max(gap, std::hypot(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y));
  for (int k = 0; k < 300; ++k) {
    const double x = low.x + random.fraction() * (high.x - low.x);
    const double y = low.y + random.fraction() * (high.y - low.y);
    const double depth = distance_from(points, x, y);
    if (depth <= pole.bound * (1 + 1e-9)) continue;
    const double allowed = std::sqrt(pole.bound * pole.bound + gap * gap / 4) * (1 + 1e-9);
    if (is_in(built, face, x, y)) {
      EXPECT_LE(depth, allowed) << face;
    }
  }
}

TEST(FacePole, OfAllFacesOfRandomMaps) {
  oracle::RandomSource random(41);
  Seen seen;
  for (int time = 0; time < 4; ++time) {
    const BuiltMap built(oracle::loose_balls(random, 40), {1, 2, 3});
    ASSERT_EQ(built.status(), hsp::Status::ok);
    for (uint32_t f = 1; f < built.map().faces.size(); ++f) {
      // In slivers samples of the outline tell nothing.
      if (built.map().faces[f].area < 1e-3 * built.map().scene.balls[0].r * built.map().scene.balls[0].r) continue;
      check_pole(built, f, random, seen);
    }
  }
  EXPECT_GT(seen.faces, 80);
  EXPECT_LT(20 * seen.loose, seen.faces);
}

TEST(FacePole, OfADiscARingAndASickle) {
  const auto pole_of = [](const BuiltMap &built, double r) {
    const hsp::VisibilityMap &map = built.map();
    for (uint32_t f = 1; f < map.faces.size(); ++f)
      if (map.scene.balls[map.faces[f].owner].r == r) return hsp::find_pole(map, f);
    return hsp::FacePole{};
  };
  const BuiltMap disc(oracle::Balls{{7, 8, 0, 500}});
  const hsp::FacePole middle = pole_of(disc, 500);
  EXPECT_NEAR(middle.radius, 500, 1e-9);
  EXPECT_NEAR(std::hypot(middle.x - disc.map().scene.balls[0].x, middle.y - disc.map().scene.balls[0].y), 0, 1e-9);
  EXPECT_GE(middle.bound, middle.radius);
  EXPECT_LE(middle.bound, middle.radius * (1 + hsp::pole_tolerance));
  // A small disc in front of a large one leaves a ring: most room is on the other side of its middle.
  for (const int64_t shift : {0, 1, 10, 100, 250}) {
    const BuiltMap ring({{0, 0, 0, 500}, {shift, 0, 2000, 240}});
    const double widest = 0.5 * (500 - 240 + static_cast<double>(shift));
    const hsp::FacePole pole = pole_of(ring, 500);
    EXPECT_LE(pole.radius, widest * (1 + 1e-12)) << shift;
    EXPECT_GE(pole.radius, widest / (1 + hsp::pole_tolerance)) << shift;
    EXPECT_GE(pole.bound, widest * (1 - 1e-12)) << shift;
    EXPECT_LE(pole.bound, pole.radius * (1 + hsp::pole_tolerance)) << shift;
  }
  // A disc almost covered: a sickle of that width in its middle, and as long as the disc.
  for (const int64_t width : {200000, 20000, 1000, 10, 1}) {
    const BuiltMap sickle({{0, 0, 0, 1000000}, {width, 0, 3000000, 1000000}});
    double room = 0;
    hsp::FacePole pole{};
    for (uint32_t f = 1; f < sickle.map().faces.size(); ++f) {
      const hsp::FacePole found = hsp::find_pole(sickle.map(), f);
      if (room == 0 || found.radius < room) pole = found;
      room = pole.radius;
    }
    EXPECT_GE(pole.radius, 0.5 * static_cast<double>(width) / (1 + hsp::pole_tolerance)) << width;
    EXPECT_LE(pole.radius, 0.5 * static_cast<double>(width) * (1 + 1e-6)) << width;
    EXPECT_GE(pole.bound, 0.5 * static_cast<double>(width) * (1 - 1e-6)) << width;
    if (width > 100000) {
      EXPECT_LE(pole.bound, pole.radius * (1 + hsp::pole_tolerance)) << width;
    }
  }
}

Point point_at(const hsp::EdgeEllipse &ellipse, double t) {
  return {ellipse.centre[0] + std::cos(t) * ellipse.first[0] + std::sin(t) * ellipse.second[0],
          ellipse.centre[1] + std::cos(t) * ellipse.first[1] + std::sin(t) * ellipse.second[1]};
}
double distance(const Point &p, const Point &q) {
  return std::hypot(p.x - q.x, p.y - q.y);
}

// Half the width of a narrow strip between two edges where it is widest: from many points of one edge to the nearest of
// the other one, whose parameter is about the same.
double half_of_widest(const hsp::VisibilityMap &map, const hsp::MapEdge &edge, const hsp::MapEdge &other) {
  const hsp::EdgeEllipse own = map.scene.curve(edge, {}, {}).ellipse, across = map.scene.curve(other, {}, {}).ellipse;
  double widest = 0;
  const double from = std::max(edge.from, other.from), to = std::min(edge.to, other.to);
  for (int k = 1; k < 1000; ++k) {
    const Point p = point_at(own, from + (to - from) * k / 1000);
    double low = from, high = to;
    while (high - low > 1e-12) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      if (distance(p, point_at(across, a)) < distance(p, point_at(across, b))) {
        high = b;
      } else {
        low = a;
      }
    }
    if (low > from + 1e-3 && high < to - 1e-3) widest = std::max(widest, distance(p, point_at(across, low)));
  }
  return widest / 2;
}

// The band that a ball leaves between two others, seen askew: a strip between two ellipses, so narrow that no square of
// the search lies in it. A fourth ball hides one end, so that the middles of the edges are nowhere special.
TEST(FacePole, OfAStripBetweenTwoEllipses) {
  for (const double width : {1e5, 1e4, 1e3, 1e2}) {
    const int64_t middle = std::lround(std::sqrt(0.64e16 + 1.2e8 * width));
    const BuiltMap built({{-40000000, -20000000, -40000000, 100000000},
                          {0, 0, 0, middle},
                          {40000000, 20000000, 40000000, 100000000},
                          {4600000, 167700000, -27300000, 50000000}},
                         {1, 2, -1});
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::VisibilityMap &map = built.map();
    uint32_t strips = 0;
    for (uint32_t f = 1; f < map.faces.size(); ++f) {
      if (map.scene.balls[map.faces[f].owner].r != static_cast<double>(middle)) continue;
      ++strips;
      std::vector<hsp::MapEdge> sides;
      for (uint32_t h = 0; h < map.half_edges.size(); ++h) {
        const hsp::MapEdge &edge = map.edges[h / 2];
        if (map.face_of(h) == f && edge.to - edge.from > 1) sides.push_back(edge);
      }
      ASSERT_EQ(sides.size(), 2U) << width;
      const double deepest = half_of_widest(map, sides[0], sides[1]);
      const hsp::FacePole pole = hsp::find_pole(map, f);
      EXPECT_GT(deepest, 0.8 * width);
      EXPECT_LT(deepest, width);
      EXPECT_GE(pole.radius, 0.95 * deepest) << width;
      EXPECT_LE(pole.radius, 1.01 * deepest) << width;
      EXPECT_GE(pole.bound, 0.99 * deepest) << width;
      EXPECT_TRUE(is_in(built, f, pole.x, pole.y)) << width;
    }
    EXPECT_EQ(strips, 1U) << width;
  }
}

// The background between six discs around a hole.
TEST(FacePole, OfAHoleOfTheBackground) {
  oracle::Balls balls;
  for (int k = 0; k < 6; ++k)
    balls.push_back({std::lround(1000 * std::cos(k * 3.14159265358979 / 3)),
                     std::lround(1000 * std::sin(k * 3.14159265358979 / 3)), 7 * k, 550});
  const BuiltMap built(balls);
  ASSERT_EQ(built.map().faces[1].owner, hsp::no_id);
  const hsp::FacePole pole = hsp::find_pole(built.map(), 1);
  EXPECT_NEAR(pole.radius, 450, 8);
  EXPECT_NEAR(std::hypot(pole.x, pole.y), 0, 10);
}

TEST(FacePole, IsTheSameEveryTime) {
  oracle::RandomSource random(42);
  const BuiltMap built(oracle::loose_balls(random, 40), {1, 2, 3});
  for (uint32_t f = 1; f < built.map().faces.size(); ++f) {
    const hsp::FacePole one = hsp::find_pole(built.map(), f), other = hsp::find_pole(built.map(), f);
    EXPECT_TRUE(one.x == other.x && one.y == other.y && one.radius == other.radius && one.bound == other.bound);
    EXPECT_TRUE(std::isfinite(one.bound) && one.bound >= one.radius && one.radius >= 0);
  }
}

}  // namespace
