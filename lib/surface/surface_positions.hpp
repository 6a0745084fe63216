// Where corners and edges of the smooth surface lie, in lattice steps.
#pragma once

#include "measure/boundary_positions.hpp"
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

}  // namespace hsp
