// The rates of vertices and the blocks of arcs: against difference quotients of vertices, and of areas of two balls.
#include "curvature/hessians.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "built_union.hpp"

namespace {

// A common point of the spheres about (0, 0, 0), (2, 0, 0) and (0, 2, 0), above their plane.
std::array<double, 3> corner(const std::array<double, 3> &radius) {
  const double x = (radius[0] * radius[0] - radius[1] * radius[1] + 4) / 4;
  const double y = (radius[0] * radius[0] - radius[2] * radius[2] + 4) / 4;
  return {x, y, std::sqrt(radius[0] * radius[0] - x * x - y * y)};
}

TEST(VertexRates, AreDifferenceQuotientsOfVertices) {
  const std::array<double, 3> radius{1.6, 1.75, 1.5}, sigma{1, -0.5, 2};
  const BuiltUnion set({{0, 0, 0, 2, 0, 0, 0, 2, 0}, {1.6, 1.75, 1.5}});
  ASSERT_EQ(set.status(), hsp::Status::ok);
  const hsp::AreaWeights weights{sigma.data()};
  const auto grown = [&](double s) {
    return corner({radius[0] + s * sigma[0], radius[1] + s * sigma[1], radius[2] + s * sigma[2]});
  };
  const double s = 1e-4;
  hsp::ArcBatches arcs(set.balls(), set.boundary(), set.ball(0));
  hsp::VertexRates rates;
  ASSERT_TRUE(arcs.next());
  ASSERT_TRUE(rates.find(set.balls(), weights, set.ball(0), arcs.batch()));
  uint32_t found = 0;
  for (uint32_t slot = 0; slot < arcs.batch().count; ++slot) {
    if (arcs.batch().arc[slot] == 0) continue;
    ++found;
    const double side = arcs.batch().pz[slot] > 0 ? 1 : -1;
    // Rates are in steps a length of growth; the weights have no unit.
    const auto quotient = [&](size_t axis) { return (grown(s)[axis] - grown(-s)[axis]) / (2 * s); };
    EXPECT_NEAR(rates.at(slot).x, quotient(0), 1e-6);
    EXPECT_NEAR(rates.at(slot).y, quotient(1), 1e-6);
    EXPECT_NEAR(rates.at(slot).z, side * quotient(2), 1e-6);
  }
  EXPECT_EQ(found, 2U);
}

TEST(VertexRates, AreRefusedInThePlaneOfTheCentres) {
  const BuiltUnion set({{3, 4, 0, -3, 4, 0, 3, -4, 0, -3, -4, 0}, {5, 5, 5, 5}});
  ASSERT_EQ(set.status(), hsp::Status::ok);
  hsp::VertexRates rates;
  bool all = true;
  for (uint32_t i = 0; i < 4; ++i) {
    hsp::ArcBatches arcs(set.balls(), set.boundary(), i);
    while (arcs.next()) all = rates.find(set.balls(), {}, i, arcs.batch()) && all;
  }
  EXPECT_FALSE(all);
}

// The free area of two balls of radius 1 and 1.25 at a distance: its second derivative along the axis.
TEST(HessianArcs, TwoBallsAlongTheirAxis) {
  const BuiltUnion set({{0, 0, 0, 1.5, 0, 0}, {1, 1.25}});
  ASSERT_EQ(set.status(), hsp::Status::ok);
  const auto area = [](double d) {
    const double h = (d * d + 1 - 1.25 * 1.25) / (2 * d);
    return 2 * hsp::pi * (1 + h) + 2 * hsp::pi * 1.25 * (1.25 + d - h);
  };
  const double s = 1e-3;
  const double quotient = (area(1.5 + s) - 2 * area(1.5) + area(1.5 - s)) / (s * s);
  for (uint32_t i = 0; i < 2; ++i) {
    hsp::EnergyTerms terms;
    terms.tension = 1;
    hsp::HessianArcs arcs(set.balls(), set.boundary(), terms, set.ball(i));
    ASSERT_TRUE(arcs.next());
    EXPECT_EQ(arcs.other(), set.ball(1 - i));
    EXPECT_NEAR(arcs.block().entry[0], -quotient, 1e-5);
    EXPECT_FALSE(arcs.next());
    EXPECT_FALSE(arcs.next());
    EXPECT_EQ(arcs.flags(), 0U);
  }
}

TEST(HessianArcs, BallsThatTouchCountAsTheyAreAsked) {
  const BuiltUnion set({{0, 0, 0, 2.25, 0, 0}, {1, 1.25}});
  ASSERT_EQ(set.status(), hsp::Status::ok);
  for (const hsp::TouchingBalls touching : {hsp::TouchingBalls::meet, hsp::TouchingBalls::apart}) {
    hsp::EnergyTerms terms;
    terms.pressure = 1;
    terms.weights.touching_balls = touching;
    hsp::HessianArcs arcs(set.balls(), set.boundary(), terms, set.ball(0));
    ASSERT_EQ(arcs.next(), touching == hsp::TouchingBalls::meet);
    EXPECT_EQ(arcs.flags(), hsp::one_sided_flag);
    // 2 pi R r / d along the axis, in the caller's unit, and nothing across it.
    if (touching == hsp::TouchingBalls::meet) {
      EXPECT_NEAR(arcs.block().entry[0], 2 * hsp::pi * 1.25 / 2.25, 1e-12);
      EXPECT_EQ(arcs.block().entry[4], 0.0);
    }
  }
}

}  // namespace
