// A surface as triangles: closed, oriented, each edge in two of them that run through it in opposite directions. Every
// vertex lies on the surface, every triangle belongs to one patch.
#pragma once

#include "core/first_index.hpp"
#include "core/fixed_vector.hpp"
#include "core/limits.hpp"
#include "surface/surface_map.hpp"

namespace hsp {

struct MeshLimits {
  uint32_t balls = 0;   // spheres with patches: balls, and vertices of the boundary for a smooth surface
  uint32_t curves = 0;  // arcs and circles of the boundary, or edges of the smooth surface
  uint32_t vertices = 0;
  uint32_t triangles = 0;
  uint32_t points = 0;  // most points of any one sphere while it is triangulated
};

struct MeshVertex {
  double position[3];  // in the caller's coordinates
  double normal[3];    // of length 1, outward; where patches meet along an edge, the middle of theirs
  uint32_t ball;       // on the smooth surface as for triangles; on a boundary a ball that it lies on, the first of
                       // these in the caller's order
};

struct MeshTriangle {
  uint32_t vertex[3];  // counter-clockwise, seen from outside
  uint32_t patch;
  uint32_t ball;  // of a saddle the one on whose side of the waist it lies, of a concave patch the one that
                  // the probe touches nearest to it
  PatchKind kind;
};

// The surface that a mesh is made of: the smooth surface, if it is given, or the boundary.
struct MeshedSurface {
  const BallSet &balls;
  const Boundary &boundary;
  const Surface *smooth = nullptr;

  // Without a probe a smooth surface is the boundary.
  bool is_smooth() const { return smooth != nullptr && balls.probe_steps != 0; }
};

class Mesh {
 public:
  uint32_t vertex_count() const { return vertices_.size(); }
  uint32_t triangle_count() const { return triangles_.size(); }
  uint32_t curve_count() const { return curves_; }
  uint32_t refined_count() const { return refined_; }  // curves with more points than their length demands
  const MeshVertex &vertex(uint32_t v) const { return vertices_[v]; }
  const MeshTriangle &triangle(uint32_t t) const { return triangles_[t]; }
  // The triangles of a patch. All triangles are in the order of their patches.
  IdRange triangles_of(uint32_t patch) const { return {first_from(patch), first_from(uint64_t{patch} + 1)}; }

 private:
  friend class MeshBuilder;

  uint32_t first_from(uint64_t patch) const {
    return first_index(0, triangle_count(), [&](uint32_t t) { return triangles_[t].patch >= patch; });
  }

  FixedVector<MeshVertex> vertices_;
  FixedVector<MeshTriangle> triangles_;
  uint32_t curves_ = 0;
  uint32_t refined_ = 0;
};

}  // namespace hsp
