#include "mesh/saddle_band.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_surface.hpp"

namespace {

double distance(const hsp::BallSet &balls, const hsp::Position &a, const hsp::Position &b) {
  const hsp::Vec3 d = balls.difference(a.ball, b.ball) + (b.offset - a.offset);
  return std::sqrt(dot(d, d));
}

// Every point is where the probe may be nearest to the axis: a probe's radius from its centre, along the normal; the
// profile begins and ends where the probe touches the balls, or on the axis.
void check_band(const BuiltSurface &built, const hsp::SaddleBand &band, double cusp_gap) {
  const hsp::BallSet &balls = built.balls();
  const double p = static_cast<double>(balls.probe_steps);
  constexpr uint32_t turns = 7;
  constexpr uint32_t rows = 5;
  for (uint32_t k = 0; k <= turns; ++k) {
    const hsp::Vec3 outward = band.outward(k, turns);
    const hsp::Position probe = band.probe(outward);
    hsp::Position end[2][2];
    for (uint32_t part = 0; part < band.parts(); ++part) {
      for (uint32_t l = 0; l <= rows; ++l) {
        const hsp::SaddleBand::Point point = band.at(outward, part, l, rows);
        EXPECT_NEAR(distance(balls, point.position, probe), p, 1e-9 * p);
        const hsp::Vec3 way =
            balls.difference(point.position.ball, probe.ball) + (probe.offset - point.position.offset);
        EXPECT_NEAR(dot(way, point.normal), p, 1e-9 * p);
        if (l == 0) end[part][0] = point.position;
        if (l == rows) end[part][1] = point.position;
      }
    }
    const uint32_t last = band.parts() - 1;
    for (uint32_t side = 0; side < 2; ++side) {
      const hsp::SaddleBand::Point touched = band.on_ball(side, outward);
      EXPECT_EQ(touched.ball, band.ball(side));
      EXPECT_NEAR(distance(balls, touched.position, end[side == 0 ? 0 : last][side]), 0.0, 1e-9 * p);
      EXPECT_NEAR(distance(balls, touched.position, {band.ball(side), {0.0, 0.0, 0.0}}), balls.r[band.ball(side)] - p,
                  1e-9 * p);
    }
    if (band.has_cusps()) {
      EXPECT_NEAR(distance(balls, end[0][1], end[1][0]), cusp_gap, 1e-6 * p);
    }
  }
}

TEST(SaddleBand, OfAWholeCircle) {
  support::BallList two;
  two.add(0.0, 0.0, 0.0, 1700.0);
  two.add(3000.0, 4000.0, 0.0, 1500.0);
  const BuiltSurface built(two, 1400.0);
  ASSERT_EQ(built.boundary().circle_count(), 1U);
  const uint32_t side =
      built.balls().given_before(built.boundary().circle(0).ball[0], built.boundary().circle(0).ball[1]) ? 1 : 0;
  check_band(built, {built.balls(), built.boundary(), hsp::LoopElement::circle({0, side}), false}, 0.0);
}

// rho^2 = 3100^2 - 3050^2, and the cusps are sqrt(p^2 - rho^2) from the middle.
TEST(SaddleBand, WithCusps) {
  support::BallList two;
  two.add(0.0, 0.0, 0.0, 1700.0);
  two.add(6100.0, 0.0, 0.0, 1700.0);
  const BuiltSurface built(two, 1400.0);
  ASSERT_EQ(built.surface().cusped_circles().count(), 1U);
  const uint32_t side =
      built.balls().given_before(built.boundary().circle(0).ball[0], built.boundary().circle(0).ball[1]) ? 1 : 0;
  const double rho_squared = 3100.0 * 3100.0 - 3050.0 * 3050.0;
  check_band(built, {built.balls(), built.boundary(), hsp::LoopElement::circle({0, side}), true},
             2 * std::sqrt(1400.0 * 1400.0 - rho_squared));
}

TEST(SaddleBand, OfArcs) {
  support::BallList three;
  three.add(0.0, 0.0, 0.0, 1700.0);
  three.add(2000.0, 300.0, 0.0, 1500.0);
  three.add(700.0, 2100.0, 100.0, 1200.0);
  const BuiltSurface built(three, 1400.0);
  ASSERT_EQ(built.boundary().arc_count(), 3U);
  for (uint32_t e = 0; e < built.boundary().half_edge_count(); ++e) {
    if (built.balls().given_before(built.boundary().ball_of(e), built.boundary().half_edge(e).circle)) continue;
    const hsp::SaddleBand band(built.balls(), built.boundary(), hsp::LoopElement::arc(e), false);
    check_band(built, band, 0.0);
    // It ends where the arc does.
    const hsp::Position end = hsp::position_of_vertex(built.balls(), built.boundary(), built.boundary().end_vertex(e));
    EXPECT_NEAR(distance(built.balls(), band.probe(band.outward(4, 4)), end), 0.0, 1e-6);
    EXPECT_NEAR(distance(built.balls(), band.probe(band.outward_at_end(1)), end), 0.0, 1e-6);
  }
}

}  // namespace
