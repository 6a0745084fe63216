#include "mesh/probe_sphere.hpp"

#include <gtest/gtest.h>

#include "divided_curves.hpp"

namespace {

// The three balls of the vertex are its own radius with probe away, and straight towards one of them that is nearest.
TEST(ProbeSphere, TouchesItsThreeBalls) {
  const BuiltSurface built(three_around(2.0), 1400.0);
  const hsp::BallSet &balls = built.balls();
  ASSERT_EQ(built.boundary().vertex_count(), 2U);
  for (uint32_t v = 0; v < 2; ++v) {
    const hsp::ProbeSphere sphere(balls, built.boundary(), v);
    for (const uint32_t ball : built.boundary().vertex(v).ball) {
      const hsp::Vec3 way = sphere.way_from({ball, {0.0, 0.0, 0.0}});
      EXPECT_NEAR(std::sqrt(dot(way, way)), balls.r[ball], 1e-9 * balls.r[ball]);
      EXPECT_EQ(sphere.nearest_ball(-way), ball);
    }
  }
}

// In the middle between equal balls it is the first one that the caller gave.
TEST(ProbeSphere, TiesGoToTheFirstBall) {
  support::BallList three;
  three.add(0.0, 0.0, 0.0, 1000.0);
  three.add(2000.0, 0.0, 0.0, 1000.0);
  three.add(0.0, 2000.0, 0.0, 1000.0);
  const BuiltSurface built(three, 1000.0);
  for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
    const hsp::ProbeSphere sphere(built.balls(), built.boundary(), v);
    const uint32_t nearest = sphere.nearest_ball({0.0, 0.0, 0.0});
    for (const uint32_t ball : built.boundary().vertex(v).ball) EXPECT_FALSE(built.balls().given_before(ball, nearest));
  }
}

}  // namespace
