// Where corners and edges of the smooth surface lie, in lattice steps.
#pragma once

#include "measure/boundary_positions.hpp"
#include "surface/probe_caps.hpp"
#include "surface/surface_map.hpp"

namespace hsp {

Position position_of_corner(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t corner);

// A piece of a circle: counter-clockwise about the axis, a unit vector.
struct ArcPosition {
  Position centre;
  Vec3 axis;
  double radius, angle;
};
ArcPosition position_of_edge(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t edge);

// An arc of a cut patch that is a crease, on the unit sphere about the vertex of its patch; its axis points to the
// vertex across.
struct VertexCrease {
  SphereArc arc;
  bool is_certain;  // if not, its axis is lost in rounding, and its height and chord are 0
};
VertexCrease crease_on_probe(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t arc);

// The circle that two vertices are on, by its balls; false if they share fewer balls, or all three.
bool find_common_circle(const Boundary &boundary, uint32_t v, uint32_t w, uint32_t (&ball)[2]);

}  // namespace hsp
