// How much a mesh will need, from what its patches measure.
#pragma once

#include "mesh/mesh.hpp"
#include "mesh/ring_points.hpp"
#include "mesh/sphere_triangulation.hpp"

namespace hsp {

// A lower bound, for meshes that are far too fine: a patch of E points by its area alone has at least 0.7 E vertices.
// A border of b segments keeps at most 0.7 b points away (share_kept_off in spherical_patch.cpp, times two over the
// square root of three) but has b points itself, which two patches share; so over all patches the vertices are at
// least E - 0.2 b, and at least b/2. A closed mesh has no fewer triangles than vertices, and with so many of them
// nearly twice as many: more than E.
class PointsInside {
 public:
  // Spheres with few points are left out.
  static bool has_many(double spacing) { return spacing < 0.1; }
  void add(double steradians, double spacing) {
    if (has_many(spacing) && steradians > 0.0) points_ += expected_ring_points(spacing) * (steradians / (4 * pi));
  }
  bool are_too_many() const { return !(points_ < max_count); }

 private:
  double points_ = 0.0;
};

// Expected sizes. Equilateral triangles have one vertex for every two triangles; those of a mesh are a little smaller.
class MeshSizes {
 public:
  void add_points(double points) { vertices_ += points; }
  // A sphere with patches of this solid angle, with so many points on their borders. Borders of many short arcs leave
  // triangles that are divided. There is room for points all over the sphere, unless they are far more than its patches
  // have.
  void add_sphere(double border, double steradians, double spacing) {
    const double everywhere = expected_ring_points(spacing < largest_ring_spacing ? spacing : largest_ring_spacing);
    const double inside = 1.2 * everywhere * steradians / (4 * pi), most_inside = 4.0 * (border + inside) + 65536.0;
    vertices_ += 0.75 * border + inside + SphereTriangulation::octahedron_points;
    const double around = 1.2 * everywhere < most_inside ? 1.2 * everywhere : most_inside;
    const double points = border + around + 2.0 * SphereTriangulation::octahedron_points + 8.0;
    if (points > most_points_) most_points_ = points;
  }
  Status limits(uint32_t spheres, uint32_t curves, MeshLimits &limits) const {
    if (!(vertices_ < max_count / 2.5) || !(most_points_ < max_count)) return Status::range;
    limits.balls = spheres;
    limits.curves = curves;
    limits.vertices = static_cast<uint32_t>(vertices_) + 16;
    limits.triangles = 2 * limits.vertices;
    limits.points = static_cast<uint32_t>(most_points_);
    return Status::ok;
  }

 private:
  double vertices_ = 0.0;
  double most_points_ = 0.0;
};

}  // namespace hsp
