#include <gtest/gtest.h>

#include "carved_memory.hpp"
#include "divided_curves.hpp"

namespace {

// The triangles of a vertex's patch lie on the probe's sphere and have about its area: whole, with a crease that is a
// circle in its middle, and in pieces between cusps.
TEST(ConcaveOutline, BoundsPatches) {
  for (const double circumradius : {0.0, 2.0, 2.9, 3.09}) {
    const BuiltSurface built(circumradius > 0.0 ? three_around(circumradius) : small_cluster(2),
                             circumradius > 0.0 ? 1400.0 : small_cluster_probe);
    const double p = static_cast<double>(built.balls().probe_steps);
    const double length = p / 20;
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::BallSet &balls = built.balls();
    const DividedCurves divided(built, length);
    for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
      CarvedMemory memory;
      hsp::SphericalPatch patch;
      memory.carve(patch, 40000U);
      patch.begin(length / p);
      const hsp::SurfaceOutline &outline = divided.get();
      const uint32_t number = balls.n + v;
      outline.add_border(number, patch);
      ASSERT_EQ(patch.triangulate(), hsp::PatchState::complete);
      uint32_t inside = 0, triangles = 0;
      const hsp::ProbeSphere sphere(balls, built.boundary(), v);
      double centre[3];
      hsp::to_coordinates(balls, sphere.centre(), centre);
      patch.emit(
          [&](const hsp::Vec3 &direction) {
            const hsp::MeshVertex vertex = outline.inner_vertex(number, direction);
            double along = 0.0;
            for (int axis = 0; axis < 3; ++axis) along += (centre[axis] - vertex.position[axis]) * vertex.normal[axis];
            EXPECT_NEAR(along, p, 1e-9 * p);
            EXPECT_EQ(outline.ball_at(number, vertex.position), vertex.ball);
            EXPECT_LT(built.boundary().vertex(v).slot_of(vertex.ball), 3U);
            ++inside;
            return UINT32_C(1) << 20;
          },
          [&](uint32_t, const uint32_t *) { ++triangles; });
      const double area = built.surface().patch(v).area;
      EXPECT_GE(triangles, area / (0.9 * length * length));
      EXPECT_LT(triangles, 6.0 * area / (length * length) + 400);
      EXPECT_GE(triangles, inside);
    }
  }
}

}  // namespace
