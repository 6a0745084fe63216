// A surface as triangles: closed, oriented, each edge in two of them that run through it in opposite directions. Every
// vertex lies on the surface, every triangle belongs to one patch.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/vec3.hpp"
#include "core/workspace.hpp"

namespace hsp {

struct MeshLimits {
  uint32_t balls = 0;
  uint32_t curves = 0;  // arcs and circles of the boundary
  uint32_t vertices = 0;
  uint32_t triangles = 0;
  uint32_t points = 0;  // most points of any one sphere while it is triangulated

  constexpr MeshLimits covering(const MeshLimits &other) const {
    return {larger_count(balls, other.balls), larger_count(curves, other.curves),
            larger_count(vertices, other.vertices), larger_count(triangles, other.triangles),
            larger_count(points, other.points)};
  }
};

// Kinds of patches, and what their numbers count.
enum class PatchKind : uint8_t {
  convex = 0,   // faces of the boundary
  saddle = 1,   // arcs, then circles
  concave = 2,  // vertices
};

struct MeshVertex {
  double position[3];  // in the caller's coordinates
  double normal[3];    // of length 1, outward; where patches meet along an edge, the middle of theirs
  uint32_t ball;       // one that it lies on: the first in the caller's order
};

struct MeshTriangle {
  uint32_t vertex[3];  // counter-clockwise, seen from outside
  uint32_t patch;
  uint32_t ball;  // one that the patch belongs to: the first in the caller's order
  PatchKind kind;
};

class Mesh {
 public:
  uint32_t vertex_count() const { return vertices_.size(); }
  uint32_t triangle_count() const { return triangles_.size(); }
  uint32_t curve_count() const { return curves_; }
  uint32_t refined_count() const { return refined_; }  // curves with more points than their length demands
  const MeshVertex &vertex(uint32_t v) const { return vertices_[v]; }
  const MeshTriangle &triangle(uint32_t t) const { return triangles_[t]; }

 private:
  friend class MeshBuilder;

  FixedVector<MeshVertex> vertices_;
  FixedVector<MeshTriangle> triangles_;
  uint32_t curves_ = 0;
  uint32_t refined_ = 0;
};

}  // namespace hsp
