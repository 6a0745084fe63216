#include "mesh/surface_curves.hpp"

#include <gtest/gtest.h>

#include "divided_curves.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

namespace {

// Bands need as many points on opposite edges; no curve's segments are longer than wanted.
TEST(SurfaceCurves, PartnersHaveAsManySegments) {
  uint32_t creases = 0;
  for (const double circumradius : {2.9, 3.09, 3.2}) {
    const BuiltSurface built(three_around(circumradius), 1400.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const DividedCurves divided(built, 150.0);
    const hsp::SurfaceCurves &curves = divided.get();
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
      const uint32_t partner = curves.partner(c);
      EXPECT_EQ(curves.partner(partner), c);
      EXPECT_EQ(curves.curve(partner).segments, curves.curve(c).segments);
      EXPECT_FALSE(curves.is_too_fine(c));
      const bool is_crease = curves.map().edge(c).kind == hsp::SurfaceEdgeKind::crease;
      EXPECT_EQ(partner == c, is_crease);
      creases += is_crease ? 1 : 0;
      if (curves.is_closed(c)) {
        EXPECT_GE(curves.curve(c).segments, 6U);
      }
      const hsp::ArcPosition arc = hsp::position_of_edge(curves.map(), c);
      EXPECT_LE(arc.radius * arc.angle, 150.0 * curves.curve(c).segments * (1 + 1e-9));
    }
  }
  EXPECT_GT(creases, 1U);
}

// From one end to the other, at the distance p from both probes.
TEST(SurfaceCurves, PointsOfCreases) {
  uint32_t open = 0, closed = 0;
  for (uint64_t seed = 0; seed < 10; ++seed) {
    const BuiltSurface built(seed == 0 ? three_around(2.9) : small_cluster(seed),
                             seed == 0 ? 1400.0 : small_cluster_probe);
    const double p = static_cast<double>(built.balls().probe_steps);
    const DividedCurves divided(built, 0.1 * p);
    const hsp::SurfaceCurves &curves = divided.get();
    const hsp::CutPatches &cut = built.surface().cut_patches();
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
      const hsp::SurfaceEdge edge = curves.map().edge(c);
      if (edge.kind != hsp::SurfaceEdgeKind::crease) continue;
      const uint32_t start = curves.map().origin(2 * c);
      const uint32_t segments = curves.curve(c).segments;
      const hsp::CirclePoints points = hsp::points_of_crease(curves.map(), c, start);
      const uint32_t probe[2] = {cut.vertex_of_arc(edge.source), cut.arc(edge.source).across};
      for (uint32_t k = 0; k <= segments; ++k) {
        for (const uint32_t v : probe) {
          const hsp::Position centre = hsp::position_of_vertex(built.balls(), built.boundary(), v);
          EXPECT_NEAR(distance_between(built.balls(), points.at(k, segments), centre), p, 1e-9 * p);
        }
      }
      const uint32_t end = curves.map().origin(2 * c + 1);
      (start == hsp::no_id ? closed : open) += 1;
      const hsp::Position last =
          start == hsp::no_id ? points.at(0, segments) : hsp::position_of_corner(curves.map(), end);
      EXPECT_NEAR(distance_between(built.balls(), points.at(segments, segments), last), 0.0, 1e-3);
    }
  }
  EXPECT_GT(open, 0U);
  EXPECT_GT(closed, 0U);
}

TEST(SurfaceCurves, RefusesMorePointsThanAnyLimitAllows) {
  const BuiltSurface built(three_around(2.9), 1400.0);
  std::vector<hsp::MeshCurve> room(hsp::SurfaceMap(built.balls(), built.boundary(), built.surface()).edge_count());
  hsp::SurfaceCurves curves(built.balls(), built.boundary(), built.surface(),
                            hsp::Span<hsp::MeshCurve>(room.data(), static_cast<uint32_t>(room.size())));
  hsp::Patience endless;
  EXPECT_FALSE(curves.divide(1e-6, endless));
}

// Twice as many points on an arc, again and again: then they are too near each other.
TEST(SurfaceCurves, KnowsWhenPointsAreTooNear) {
  const BuiltSurface built(three_around(2.9), 1400.0);
  DividedCurves divided(built, 150.0);
  for (uint32_t c = 0; c < divided.get().curve_count(); ++c) {
    if (divided.get().is_closed(c)) continue;
    divided.get().curve(c).segments = UINT32_C(1) << 28;
    EXPECT_TRUE(divided.get().is_too_fine(c));
  }
}

}  // namespace
