#include "built_surface.hpp"
#include "expect_cases.hpp"
#include "lattice_lengths.hpp"
#include "surface/surface_check.hpp"
#include "surface_builder_cases.hpp"

namespace {

TEST(SurfaceBuilder, Cases) {
  expect_cases(cases::surface_surface_builder);
}

// Balls 0 and 1 touch in the origin; spheres of others pass through it, and are seen along the axis in other
// directions. Areas differ by about the radius of the circle where inflated balls meet; a lune has 1.5 or more.
TEST(SurfaceBuilder, AreasOfTouchingBallsAreThoseOfInflatedOnes) {
  const oracle::Balls sets[] = {{{-2, -3, 6, 6}, {2, 3, -6, 6}, {2, -3, 6, 6}},
                                {{-2, -3, 6, 6}, {2, 3, -6, 6}, {2, -3, 6, 6}, {-2, 3, 6, 6}},
                                {{-2, -3, 6, 6}, {2, 3, -6, 6}, {2, -3, 6, 6}, {-2, 3, 6, 6}, {2, 3, 6, 6}},
                                {{-4, -6, 12, 13}, {2, 3, -6, 6}, {2, -3, 6, 6}, {-2, 3, 6, 6}}};
  constexpr double probe = 1.0, inflation = 0x1p-20;
  for (const oracle::Balls &balls : sets) {
    support::BallList list = oracle::in_lengths(balls, 1);
    const BuiltSurface built(list, probe);
    for (double &radius : list.radius) radius += inflation;
    const BuiltSurface inflated(list, probe, inflation);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    ASSERT_EQ(inflated.status(), hsp::Status::ok);
    EXPECT_NEAR(built.total().area(), inflated.total().area(), 0.1);
    EXPECT_NEAR(built.total().concave, inflated.total().concave, 0.1);
    EXPECT_EQ(hsp::check_surface({built.balls(), built.boundary(), built.surface()}).invariant,
              hsp::SurfaceInvariant::none);
  }
}

// Two creases of one patch begin in one place, as far as doubles tell: which is the first one around their circle?
TEST(SurfaceBuilder, CreasesThatBeginInOnePlace) {
  support::BallList list;
  list.add(0.000000002, -0.000000006, -0.000000006, 0);
  list.add(-1.875000002, -0.000000006, 0.000000002, 1.125);
  list.add(-0.750000005, -0.000000006, -0.000000006, 0.25);
  list.add(-0.000000002, 0.999999999, -0.000000001, 0.25);
  list.add(-0.250000004, -0.800000008, 0.600000008, 0);
  list.add(0.249999996, 0.999999991, -0.000000007, 0.25);
  const BuiltSurface built(list, 1.0, 0.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_EQ(hsp::check_surface({built.balls(), built.boundary(), built.surface()}).invariant,
            hsp::SurfaceInvariant::none);
}

// The probe stands between two balls that it touches in opposite points, at a vertex: any plane through both has the
// side between them.
TEST(SurfaceBuilder, ProbesBetweenTwoBalls) {
  support::BallList list;
  list.add(-0.4, -0.6, 0.8, 0.2);
  list.add(-0.2, -0.8, 0.6, 0);
  list.add(-0.6, 0.8, -0.4, 1);
  list.add(0.4, 0.2, 0.4, 0);
  list.add(0.8, 0.6, -0.2, 0.4);
  list.add(-0.6, -0.8, -0.8, 0);
  list.add(0.4, 0.8, 0.8, 0.1);
  const BuiltSurface built(list, 0.5, 0.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_EQ(hsp::check_surface({built.balls(), built.boundary(), built.surface()}).invariant,
            hsp::SurfaceInvariant::none);
}

}  // namespace
