#include <gtest/gtest.h>

#include <cmath>

#include "carved_memory.hpp"
#include "divided_curves.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

namespace {

hsp::Position position_of(const hsp::BallSet &balls, const hsp::MeshVertex &vertex) {
  const hsp::Vec3 offset{balls.lattice.steps(vertex.position[0]) - static_cast<double>(balls.x[vertex.ball]),
                         balls.lattice.steps(vertex.position[1]) - static_cast<double>(balls.y[vertex.ball]),
                         balls.lattice.steps(vertex.position[2]) - static_cast<double>(balls.z[vertex.ball])};
  return {vertex.ball, offset};
}

// No vertex lies in a probe. All corners lie on the sphere of one; so do the points of creases and sides, and those of
// rims lie on their ball.
TEST(SurfaceVertices, LieOnTheSurface) {
  uint32_t kinds[4] = {0, 0, 0, 0};
  for (uint64_t seed = 0; seed < 6; ++seed) {
    oracle::RandomSource random(seed);
    const BuiltSurface built(seed == 0   ? three_around(2.9)
                             : seed == 1 ? three_around(3.09)
                             : seed == 2 ? three_around(3.2)
                                         : oracle::in_lengths(oracle::loose_balls(random, 30), 1),
                             seed < 3 ? 1400.0 : 40.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::BallSet &balls = built.balls();
    const double p = static_cast<double>(balls.probe_steps);
    const DividedCurves divided(built, 0.3 * p);
    const hsp::SurfaceCurves &source = divided.get();
    const auto expect_unit = [](const hsp::MeshVertex &vertex) {
      const double *const n = vertex.normal;
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0, 1e-12);
    };
    const hsp::SurfaceMap &map = source.map();
    for (uint32_t id = 0; id < map.corner_count(); ++id) {
      const hsp::MeshVertex vertex = source.corner(id);
      expect_unit(vertex);
      if (built.boundary().vertex_count() == 0) continue;
      EXPECT_NEAR(depth_in_probes(built, position_of(balls, vertex)), 0.0, 1e-4 * p) << seed << " corner " << id;
    }
    std::vector<hsp::MeshVertex> room(1000);
    for (uint32_t c = 0; c < source.curve_count(); ++c) {
      hsp::FixedVector<hsp::MeshVertex> vertices(hsp::Span<hsp::MeshVertex>(room.data(), 1000U));
      source.add_samples(c, vertices);
      const uint32_t ends = source.is_closed(c) ? 0 : 1;
      ASSERT_EQ(vertices.required(), source.curve(c).segments - ends);
      const hsp::SurfaceEdgeKind kind = map.edge(c).kind;
      ++kinds[static_cast<uint32_t>(kind)];
      for (uint32_t k = 0; k < vertices.size(); ++k) {
        expect_unit(vertices[k]);
        const hsp::Position position = position_of(balls, vertices[k]);
        const bool on_ball = kind == hsp::SurfaceEdgeKind::rim || kind == hsp::SurfaceEdgeKind::circle_rim;
        if (on_ball) {
          EXPECT_NEAR(std::sqrt(dot(position.offset, position.offset)), balls.r[vertices[k].ball] - p, 1e-6 * p);
        }
        if (built.boundary().vertex_count() == 0) continue;
        const double depth = depth_in_probes(built, position);
        EXPECT_LT(depth, 1e-6 * p);
        if (!on_ball) {
          EXPECT_GT(depth, -1e-6 * p);
        }
      }
    }
  }
  for (const uint32_t kind : kinds) EXPECT_GT(kind, 0U);
}

}  // namespace
