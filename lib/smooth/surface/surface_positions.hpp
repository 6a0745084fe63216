// Where corners and edges of the smooth surface lie, in lattice steps.
#pragma once

#include "measure/boundary_positions.hpp"
#include "surface/border_points.hpp"
#include "surface/probe_caps.hpp"
#include "surface/surface_map.hpp"

namespace hsp {

Position position_of_corner(const SurfaceMap &map, uint32_t corner);

// A piece of a circle: counter-clockwise about the axis, a unit vector.
struct ArcPosition {
  Position centre;
  Vec3 axis;
  double radius, angle;
};
ArcPosition position_of_edge(const SurfaceMap &map, uint32_t edge);

// An arc of a cut patch that is a crease, on the unit sphere about the vertex of its patch; its axis points to the
// vertex across.
struct VertexCrease {
  SphereArc arc;
  bool is_certain;  // if not, its axis is lost in rounding, and its height and chord are 0
};
VertexCrease crease_on_probe(const SurfaceMap &map, uint32_t arc);

// The circle that two vertices are on, by its balls; false if they share fewer balls, or all three.
bool find_common_circle(const Boundary &boundary, uint32_t v, uint32_t w, uint32_t (&ball)[2]);

// The unit vector along v; `instead` if v has no length.
inline Vec3 unit(const Vec3 &v, const Vec3 &instead) {
  const double square = dot(v, v);
  return square > 0.0 ? 1.0 / std::sqrt(square) * v : instead;
}

// A direction perpendicular to a unit vector, and to the coordinate axis that it is least along.
inline Vec3 perpendicular_to(const Vec3 &axis) {
  constexpr Vec3 axes[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const Vec3 &other = axes[axis_least_along(axis)];
  return unit(cross(axis, other), other);
}

}  // namespace hsp
