#include <gtest/gtest.h>

#include <cmath>

#include "carved_memory.hpp"
#include "divided_curves.hpp"
#include "measure/areas.hpp"

namespace {

// The triangles of each ball's convex patches have about the area of its face, and its points lie on the ball.
void check_balls(const BuiltSurface &built, double length) {
  const hsp::BallSet &balls = built.balls();
  const double p = static_cast<double>(balls.probe_steps);
  const DividedCurves divided(built, length);
  for (uint32_t i = 0; i < balls.n; ++i) {
    CarvedMemory memory;
    hsp::SphericalPatch patch;
    memory.carve(patch, 20000U);
    const double radius = balls.r[i] - p;
    patch.begin(length / radius);
    const hsp::SurfaceOutline &outline = divided.get();
    outline.add_border(i, patch);
    ASSERT_EQ(patch.triangulate(), hsp::PatchState::complete);
    uint32_t inside = 0, triangles = 0;
    patch.emit(
        [&](const hsp::Vec3 &direction) {
          const hsp::MeshVertex vertex = outline.inner_vertex(i, direction);
          EXPECT_EQ(vertex.ball, i);
          const double arm[3] = {vertex.position[0] - balls.lattice.length(static_cast<double>(balls.x[i])),
                                 vertex.position[1] - balls.lattice.length(static_cast<double>(balls.y[i])),
                                 vertex.position[2] - balls.lattice.length(static_cast<double>(balls.z[i]))};
          double along = 0.0;
          for (int axis = 0; axis < 3; ++axis) along += arm[axis] * vertex.normal[axis];
          EXPECT_NEAR(along, balls.lattice.length(radius), 1e-9 * radius);
          ++inside;
          return UINT32_C(1) << 20;
        },
        [&](uint32_t, const uint32_t *) { ++triangles; });
    const double R = balls.r[i];
    const double area = hsp::measure_ball(balls, built.boundary(), i).area * radius * radius / (R * R);
    // Equilateral triangles have 2.3 of length^2 for each point.
    EXPECT_GT(triangles, area / (0.9 * length * length));
    EXPECT_GT(inside, 0.5 * area / (0.9 * length * length));
  }
}

TEST(ConvexOutline, BoundsArcsAndCircles) {
  check_balls(BuiltSurface(three_around(2.0), 1400.0), 150.0);
  check_balls(BuiltSurface(three_around(3.09), 1400.0), 150.0);
  check_balls(BuiltSurface(three_around(3.2), 1400.0), 150.0);
}

}  // namespace
