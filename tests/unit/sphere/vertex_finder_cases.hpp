// Vertices and free circles of small unions: their numbers, and that every vertex lies on its three spheres and outside
// all other balls.
#pragma once

#include "small_union.hpp"
#include "sphere/arc_geometry.hpp"

namespace cases {

struct Scene {
  uint32_t n;
  SmallBall ball[8];
  uint32_t vertices, circles, faces, shells, components;
};
constexpr Scene scenes[] = {
    {1, {{1, 2, 3, 4}}, 0, 0, 1, 1, 1},
    {2, {{0, 0, 0, 500}, {600, 0, 0, 500}}, 0, 1, 2, 1, 1},
    {2, {{0, 0, 0, 500}, {5000, 0, 0, 500}}, 0, 0, 2, 2, 2},
    {2, {{0, 0, 0, 500}, {100, 0, 0, 100}}, 0, 0, 1, 1, 1},
    {3, {{0, 0, 0, 500}, {600, 0, 0, 500}, {1200, 0, 0, 500}}, 0, 2, 3, 1, 1},
    {3, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}}, 2, 0, 3, 1, 1},
    {4, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}, {500, 300, 800, 1000}}, 4, 0, 4, 1, 1},
    {4, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 866, 0, 300}, {500, -866, 0, 300}}, 4, 0, 4, 1, 1},
    // Three balls in a ring: a torus.
    {3, {{0, 0, 0, 550}, {1000, 0, 0, 550}, {500, 866, 0, 550}}, 0, 3, 3, 1, 1},
    // Six around a void: both common points of each of the eight triples are free.
    {6,
     {{1000, 0, 0, 850},
      {-1000, 0, 0, 850},
      {0, 1000, 0, 850},
      {0, -1000, 0, 850},
      {0, 0, 1000, 850},
      {0, 0, -1000, 850}},
     16,
     0,
     12,
     2,
     1},
    // The same with a ball in the void, and one beside it.
    {8,
     {{1000, 0, 0, 850},
      {-1000, 0, 0, 850},
      {0, 1000, 0, 850},
      {0, -1000, 0, 850},
      {0, 0, 1000, 850},
      {0, 0, -1000, 850},
      {0, 0, 0, 100},
      {9000, 0, 0, 10}},
     16,
     0,
     14,
     4,
     3}};

inline uint32_t vertices_of_small_unions() {
  return first_failing(scenes, [](const Scene &c) {
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
