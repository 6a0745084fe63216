// Every vertex of a mesh lies on its surface, however long the edges are: also where chords of short arcs leave much
// room beside these.
#include <array>
#include <initializer_list>

#include "mesh_convergence.hpp"
#include "sweep_length.hpp"

namespace {

support::BallList balls_of(std::initializer_list<std::array<double, 4>> rows) {
  support::BallList balls;
  for (const auto &[x, y, z, r] : rows) balls.add(x, y, z, r);
  return balls;
}

void expect_boundary_vertices(const support::BallList &list, double edge) {
  const MeshedBalls balls(list, 0.0);
  expect_sound(MadeMesh(balls.boundary(), edge), balls.boundary().counts.euler);
}

void expect_surface_vertices(const support::BallList &list, double probe, double edge) {
  const MeshedBalls balls(list, probe);
  const MadeMesh mesh(balls.surface(), edge);
  expect_sound(mesh, balls.surface_euler());
  expect_on_surface(mesh, probe);
}

// A corner of the octahedron that a triangulation begins with lies between a chord and its arc: on a ball ...
TEST(Vertices, AreOutsideOfTwoBalls) {
  expect_boundary_vertices(balls_of({{1.02, 0.45, 1.26, 0.7}, {0.04, 0.51, 0.35, 0.86}}), 0.55);
}

// ... on a convex patch beside its saddle ...
TEST(Vertices, AreOnConvexPatches) {
  expect_surface_vertices(balls_of({{0.1, 1.2, 0.7, 1.2}, {1.5, 2, 1.7, 0.7}}), 0.3, 0.7);
}

// ... and on a concave one that another probe cuts.
TEST(Vertices, AreOnConcavePatches) {
  expect_surface_vertices(balls_of({{2.5, 1.9, 1, 1.1}, {1, 2.2, 0.1, 1.1}, {0.8, 0.2, 0.1, 0.9}}), 0.3, 0.7);
}

// Edges of 0.05 to 1 of the largest radius that there may be.
TEST(Vertices, OfRandomSetsLieOnTheirSurfaces) {
  for (uint64_t seed = 1; seed <= static_cast<uint64_t>(oracle::sets(12)); ++seed) {
    SCOPED_TRACE(seed);
    expect_vertices_of_atoms(seed);
  }
}

}  // namespace
