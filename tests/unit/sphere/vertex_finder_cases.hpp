// Vertices and free circles of small unions: their numbers, and that every vertex lies on its three spheres and outside
// all other balls.
#pragma once

#include "small_scenes.hpp"
#include "sphere/arc_geometry.hpp"

namespace cases {

inline uint32_t vertices_of_small_unions() {
  return first_failing_scene([](const Scene &c) {
    SmallUnion &built = small_union();
    if (!built.build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = built.boundary();
    if (boundary.vertex_count() != c.vertices || boundary.circle_count() != c.circles) return false;
    const hsp::BallSet &balls = built.balls();
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      const hsp::VertexRecord &vertex = boundary.vertex(v);
      if (vertex.tied() || vertex.ball[0] >= vertex.ball[1] || vertex.ball[1] >= vertex.ball[2]) return false;
      const hsp::exact::LatticeBall own = balls.ball(vertex.ball[0]);
      const hsp::Vec3 p =
          hsp::crossing_point(plane_of(own, balls.ball(vertex.ball[1])), plane_of(own, balls.ball(vertex.ball[2])),
                              vertex.positive() ? 1 : -1, boundary.root_discriminant(v));
      for (uint32_t i = 0; i < c.n; ++i) {
        const double x = balls.x[vertex.ball[0]] + p.x - balls.x[i];
        const double y = balls.y[vertex.ball[0]] + p.y - balls.y[i];
        const double z = balls.z[vertex.ball[0]] + p.z - balls.z[i];
        const double beyond = std::sqrt(x * x + y * y + z * z) - balls.r[i];
        const bool on = i == vertex.ball[0] || i == vertex.ball[1] || i == vertex.ball[2];
        if (on ? !near(beyond, 0.0, 1e-9) : beyond < 1e-9) return false;
      }
    }
    return true;
  });
}

inline constexpr Check sphere_vertex_finder[] = {{"vertices_of_small_unions", vertices_of_small_unions}};

}  // namespace cases
