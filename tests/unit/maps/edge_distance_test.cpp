// How near edges come, against many points of them.
#include "maps/face_pole.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "built_map.hpp"
#include "maps/edge_geometry.hpp"
#include "random_balls.hpp"

namespace {

double sampled(const hsp::VisibilityMap &map, uint32_t e, double x, double y) {
  const hsp::MapEdge &edge = map.edges[e];
  const hsp::EdgeEllipse ellipse = map.scene.curve(edge, {}, {}).ellipse;
  const auto distance = [&](double t) {
    return std::hypot(ellipse.centre[0] + std::cos(t) * ellipse.first[0] + std::sin(t) * ellipse.second[0] - x,
                      ellipse.centre[1] + std::cos(t) * ellipse.first[1] + std::sin(t) * ellipse.second[1] - y);
  };
  constexpr int samples = 200;
  const double step = (edge.to - edge.from) / samples;
  int best = 0;
  for (int k = 1; k <= samples; ++k)
    if (distance(edge.from + k * step) < distance(edge.from + best * step)) best = k;
  // Then by thirds.
  double low = std::max(edge.from, edge.from + (best - 1) * step),
         high = std::min(edge.to, edge.from + (best + 1) * step);
  for (int k = 0; k < 60; ++k) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
  }
  return distance(0.5 * (low + high));
}

TEST(EdgeDistance, IsThatOfTheNearestOfManyPoints) {
  oracle::RandomSource random(31);
  int creases = 0, within = 0;
  for (int time = 0; time < 6; ++time) {
    const BuiltMap built(oracle::loose_balls(random, 30), {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    for (uint32_t e = 0; e < map.edges.size(); ++e) {
      const hsp::MapEdge &edge = map.edges[e];
      const hsp::SeenBall &ball = map.scene.balls[edge.body];
      for (int k = 0; k < 5; ++k) {
        // Near the ball, in its middle, and far away.
        const double reach = k == 0 ? 0.0 : k == 4 ? 20 * ball.r : 1.2 * ball.r;
        const double x = ball.x + reach * (2 * random.fraction() - 1);
        const double y = ball.y + reach * (2 * random.fraction() - 1);
        hsp::NearestPoint nearest;
        look_at_edge(map, e, x, y, nearest);
        const double found = std::sqrt(nearest.squared);
        EXPECT_NEAR(found, sampled(map, e, x, y), 1e-6 * ball.r) << e;
        EXPECT_NEAR(found, std::hypot(nearest.x - x, nearest.y - y), 1e-9 * ball.r);
        creases += edge.is_silhouette() ? 0 : 1;
        const auto ends_at = [&](uint32_t v) {
          return map.vertices[v].x == nearest.x && map.vertices[v].y == nearest.y;
        };
        within += ends_at(edge.vertex[0]) || ends_at(edge.vertex[1]) ? 0 : 1;
      }
    }
  }
  EXPECT_GT(creases, 500);
  EXPECT_GT(within, 300);
}

TEST(EdgeDistance, KeepsWhatIsNearer) {
  const BuiltMap built(oracle::Balls{{0, 0, 0, 50}, {200, 0, 0, 20}});
  const hsp::VisibilityMap &map = built.map();
  ASSERT_EQ(map.edges.size(), 2U);
  for (uint32_t e = 0; e < 2; ++e) {
    const hsp::SeenBall &ball = map.scene.balls[map.edges[e].body];
    hsp::NearestPoint nearest;
    look_at_edge(map, e, ball.x + 0.6 * ball.r, ball.y - 0.8 * ball.r + 1, nearest);
    const hsp::NearestPoint before = nearest;
    EXPECT_LT(before.squared, 1.0);
    look_at_edge(map, 1 - e, ball.x + 0.6 * ball.r, ball.y - 0.8 * ball.r + 1, nearest);
    EXPECT_EQ(nearest.x, before.x);
    EXPECT_EQ(nearest.y, before.y);
    EXPECT_EQ(nearest.squared, before.squared);
  }
}

}  // namespace
