// Concave patches without area, where circles touch: they join what is beside them.
#include "surface/flat_patches.hpp"

#include <gtest/gtest.h>

#include "built_surface.hpp"
#include "lattice_lengths.hpp"
#include "surface/surface_check.hpp"
#include "surface/surface_map.hpp"

namespace {

struct FlatSet {
  const char *name;
  oracle::Balls balls;  // with the probe
  double probe;
  uint32_t pieces;   // of all patches
  uint32_t creases;  // among them
  int64_t euler;     // of the whole surface
};

// Circles that touch on a sphere, beside each other or one inside the other; four balls around the middle of a
// rectangle, where the probe leaves a tunnel as it comes from both sides, and with the larger one two bodies.
const FlatSet sets[] = {
    {"beside each other", {{0, 0, 0, 5}, {8, 4, 0, 5}, {8, -4, 0, 5}}, 2, 2, 1, 0},
    {"beside each other, cusps", {{0, 0, 0, 5}, {8, 4, 0, 5}, {8, -4, 0, 5}}, 4, 6, 3, 6},
    {"one inside the other", {{0, 0, 0, 5}, {8, 4, 0, 5}, {5, 5, 0, 5}}, 2, 2, 0, 2},
    {"on a circle of two", {{-3, 0, 0, 5}, {3, 0, 0, 5}, {0, 9, 0, 5}}, 3, 4, 2, 4},
    {"rectangle", {{6, 8, 0, 10}, {6, -8, 0, 10}, {-6, 8, 0, 10}, {-6, -8, 0, 10}}, 2, 4, 2, 0},
    {"rectangle, cusps", {{6, 8, 0, 10}, {6, -8, 0, 10}, {-6, 8, 0, 10}, {-6, -8, 0, 10}}, 7, 8, 4, 4},
};

int64_t euler_of(const BuiltSurface &built) {
  int64_t sum = 0;
  hsp::count_euler(built.balls(), built.boundary(), built.surface(), [&sum](uint32_t, int32_t n) { sum += n; });
  return sum;
}

TEST(FlatPatches, JoinWhatIsBesideThem) {
  for (const FlatSet &set : sets) {
    SCOPED_TRACE(set.name);
    oracle::Balls balls = set.balls;
    for (oracle::LatticeBall &ball : balls) ball.radius -= static_cast<int64_t>(set.probe);
    const BuiltSurface built(oracle::in_lengths(balls, 1), set.probe);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::Surface &surface = built.surface();
    EXPECT_TRUE(surface.is_closed());
    EXPECT_EQ(surface.counts().hidden_patches, 0U);
    EXPECT_EQ(hsp::check_surface(built.balls(), built.boundary(), surface).invariant, hsp::SurfaceInvariant::none);
    for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
      hsp::Vec3 normal;
      EXPECT_TRUE(hsp::is_flat(built.balls(), built.boundary(),
                               hsp::position_of_vertex(built.balls(), built.boundary(), v), v, normal));
      EXPECT_EQ(surface.patch(v).area, 0.0);
    }
    EXPECT_EQ(surface.cut_patches().piece_count(), set.pieces);
    EXPECT_EQ(surface.counts().joints.creases, set.creases);
    for (uint32_t a = 0; a < surface.cut_patches().arc_count(); ++a) {
      const hsp::PatchArc &arc = surface.cut_patches().arc(a);
      EXPECT_TRUE(arc.is_side() || arc.angle > 0.1);
    }
    EXPECT_EQ(euler_of(built), set.euler);
  }
}

// Balls that are points without the probe: circles have their cusps in them, where the sides of a strip end.
TEST(FlatPatches, OfBallsThatArePoints) {
  const oracle::Balls balls = {{2, 3, 5, 2}, {3, 2, 5, 0}, {0, 3, 3, 0}, {3, 0, 3, 0}, {1, 4, 5, 0}, {2, 0, 2, 0},
                               {2, 4, 4, 2}, {0, 0, 0, 0}, {2, 4, 4, 1}, {3, 6, 6, 0}, {3, 6, 6, 2}, {3, 6, 6, 2}};
  const BuiltSurface built(oracle::in_lengths(balls, 1), 2);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_TRUE(built.surface().is_closed());
  EXPECT_EQ(hsp::check_surface(built.balls(), built.boundary(), built.surface()).invariant,
            hsp::SurfaceInvariant::none);
  uint32_t flat = 0;
  for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
    hsp::Vec3 normal;
    const hsp::Position place = hsp::position_of_vertex(built.balls(), built.boundary(), v);
    flat += hsp::is_flat(built.balls(), built.boundary(), place, v, normal) ? 1 : 0;
  }
  EXPECT_EQ(flat, 2U);
}

}  // namespace
