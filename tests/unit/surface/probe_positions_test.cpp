// Where two balls touch and others pass through the point: probes stand beside it, and see lunes.
#include "surface/probe_positions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_surface.hpp"
#include "lattice_lengths.hpp"
#include "surface/surface_check.hpp"

namespace {

constexpr double probe = 1.0;
constexpr double inflation = 0x1p-20;

// Balls 0 and 1 touch in the origin; spheres of others pass through it, and are seen along the axis in other
// directions. Radii are without the probe.
struct TouchingSet {
  const char *name;
  oracle::Balls balls;
  uint32_t beside;  // vertices that stand off the point
};
const TouchingSet sets[] = {
    {"one other", {{-2, -3, 6, 6}, {2, 3, -6, 6}, {2, -3, 6, 6}}, 0},
    {"two others", {{-2, -3, 6, 6}, {2, 3, -6, 6}, {2, -3, 6, 6}, {-2, 3, 6, 6}}, 2},
    {"three others, one between", {{-2, -3, 6, 6}, {2, 3, -6, 6}, {2, -3, 6, 6}, {-2, 3, 6, 6}, {2, 3, 6, 6}}, 2},
    {"two others, one of them smaller", {{-4, -6, 12, 13}, {2, 3, -6, 6}, {2, -3, 6, 6}, {-2, 3, 6, 6}}, 2},
};

// Areas differ by about the radius of the circle where inflated balls meet; a lune has 1.5 or more.
TEST(ProbePositions, AreasAreThoseOfInflatedBalls) {
  for (const TouchingSet &set : sets) {
    SCOPED_TRACE(set.name);
    support::BallList list = oracle::in_lengths(set.balls, 1);
    const BuiltSurface built(list, probe);
    for (double &radius : list.radius) radius += inflation;
    const BuiltSurface inflated(list, probe, inflation);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    ASSERT_EQ(inflated.status(), hsp::Status::ok);
    const hsp::SurfaceMeasure found = built.total();
    const hsp::SurfaceMeasure expected = inflated.total();
    EXPECT_NEAR(found.area(), expected.area(), 0.1);
    EXPECT_NEAR(found.concave, expected.concave, 0.1);
    EXPECT_EQ(hsp::check_surface(built.balls(), built.boundary(), built.surface()).invariant,
              hsp::SurfaceInvariant::none);
  }
}

TEST(ProbePositions, BesideThePoint) {
  for (const TouchingSet &set : sets) {
    SCOPED_TRACE(set.name);
    const BuiltSurface built(oracle::in_lengths(set.balls, 1), probe);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    uint32_t beside = 0;
    for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
      const hsp::Vec3 way = hsp::way_off_touching_point(built.balls(), built.boundary(), v);
      const hsp::Position at = hsp::position_of_probe(built.balls(), built.boundary(), v);
      const hsp::Vec3 off = at.offset - hsp::position_of_vertex(built.balls(), built.boundary(), v).offset;
      const double length = std::sqrt(dot(way, way));
      EXPECT_NEAR(std::sqrt(dot(off, off)), length * hsp::radius_of_touching * probe, 1e-15);
      if (length == 0.0) continue;
      ++beside;
      EXPECT_NEAR(length, 1.0, 1e-15);
      for (const uint32_t b : built.boundary().vertex(v).ball) {
        EXPECT_NEAR(dot(way, built.balls().difference(at.ball, b) - at.offset), 0.0, 1e-6);
      }
    }
    EXPECT_EQ(beside, set.beside);
  }
}

}  // namespace
