#include "mesh/boundary_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_boundary.hpp"
#include "carved_memory.hpp"

namespace {

const oracle::Balls three = {{0, 0, 0, 1000}, {900, 100, 0, 1100}, {300, 800, 100, 900}};
const oracle::Balls two = {{0, 0, 0, 1000}, {900, 100, 0, 1100}};

double distance_to(const hsp::BallSet &balls, uint32_t i, const hsp::Position &p) {
  const hsp::Vec3 arm = balls.difference(i, p.ball) + p.offset;
  return std::sqrt(dot(arm, arm));
}

TEST(BoundaryCurves, BothHalfEdgesOfAnArcHaveOneCurve) {
  const BuiltBoundary built(three);
  const hsp::Boundary &boundary = built.boundary();
  CarvedMemory memory;
  hsp::BoundaryCurves curves;
  memory.carve(curves, boundary.arc_count());
  hsp::Patience endless;
  ASSERT_TRUE(curves.build(built.balls(), boundary, 100.0, endless));
  ASSERT_EQ(curves.count(), boundary.arc_count());
  for (uint32_t e = 0; e < boundary.half_edge_count(); ++e) {
    const hsp::LoopElement own = hsp::LoopElement::arc(e), twin = hsp::LoopElement::arc(boundary.twin(e));
    const uint32_t c = curves.of(own);
    EXPECT_EQ(c, curves.of(twin));
    EXPECT_TRUE(curves.curve(c).element == own || curves.curve(c).element == twin);
  }
}

// The points of an arc lie on both spheres, in no other ball, from one end to the other, as far apart as wanted.
TEST(BoundaryCurves, PointsRunAlongTheArc) {
  const BuiltBoundary built(three);
  const hsp::Boundary &boundary = built.boundary();
  const hsp::BallSet &balls = built.balls();
  CarvedMemory memory;
  hsp::BoundaryCurves curves;
  memory.carve(curves, boundary.arc_count());
  hsp::Patience endless;
  ASSERT_TRUE(curves.build(balls, boundary, 100.0, endless));
  for (uint32_t c = 0; c < curves.count(); ++c) {
    const hsp::MeshCurve &curve = curves.curve(c);
    const hsp::CirclePoints points = hsp::points_of_curve(balls, boundary, curve.element);
    const uint32_t own = boundary.ball_of(curve.element);
    const uint32_t other = boundary.neighbour(curve.element);
    const uint32_t third = 3 - own - other;
    hsp::Position last{};
    for (uint32_t k = 0; k <= curve.segments; ++k) {
      const hsp::Position p = points.at(k, curve.segments);
      EXPECT_NEAR(distance_to(balls, own, p), balls.r[own], 1e-9);
      EXPECT_NEAR(distance_to(balls, other, p), balls.r[other], 1e-9);
      if (k > 0 && k < curve.segments) {
        EXPECT_GT(distance_to(balls, third, p), balls.r[third]);
      }
      if (k > 0) {
        const hsp::Vec3 step = p.offset - last.offset;
        EXPECT_LE(std::sqrt(dot(step, step)), 100.0);
      }
      last = p;
    }
    EXPECT_NEAR(distance_to(balls, third, last), balls.r[third], 1e-9);
    EXPECT_NEAR(distance_to(balls, third, points.at(0, curve.segments)), balls.r[third], 1e-9);
  }
}

TEST(BoundaryCurves, CirclesCloseAndMayBeEnlarged) {
  const BuiltBoundary built(two);
  CarvedMemory memory;
  hsp::BoundaryCurves curves;
  memory.carve(curves, 1U);
  hsp::Patience endless;
  ASSERT_TRUE(curves.build(built.balls(), built.boundary(), 100.0, endless));
  ASSERT_EQ(curves.count(), 1U);
  const hsp::MeshCurve &curve = curves.curve(0);
  ASSERT_TRUE(curve.element.is_circle());
  const hsp::CirclePoints points = hsp::points_of_curve(built.balls(), built.boundary(), curve.element);
  const hsp::Position first = points.at(0, curve.segments);
  const hsp::Vec3 gap = first.offset - points.at(curve.segments, curve.segments).offset;
  EXPECT_NEAR(dot(gap, gap), 0.0, 1e-18);
  const double radius = distance_to(built.balls(), first.ball, first);
  const hsp::CirclePoints wider = hsp::points_of_curve(built.balls(), built.boundary(), curve.element, 5000.0);
  EXPECT_NEAR(radius, built.balls().r[first.ball], 1e-9);
  EXPECT_GT(distance_to(built.balls(), first.ball, wider.at(0, curve.segments)), 4999.0);
}

TEST(BoundaryCurves, RefusesMorePointsThanAnyLimitAllows) {
  const BuiltBoundary built(two);
  CarvedMemory memory;
  hsp::BoundaryCurves curves;
  memory.carve(curves, 1U);
  hsp::Patience endless;
  EXPECT_FALSE(curves.build(built.balls(), built.boundary(), 1e-9, endless));
}

}  // namespace
