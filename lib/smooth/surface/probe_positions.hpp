// Where the probe of a vertex of the boundary stands: at the vertex, but where two of its balls touch each other there.
//
// Under the symbolic perturbation balls that touch meet in a circle that is infinitely small, but infinitely larger
// than what moves the third ball of a vertex on it, as a root. So the vertex lies off the point at right angles to the
// third ball, and sees a lune between the two opposite directions to the balls that touch: of a right angle, unless the
// vertex across the gap cuts it (PROOFS.md, section 11). Here the circle gets a radius that is small but not nothing,
// so that directions exist; areas are off by about as much.
#pragma once

#include "measure/boundary_positions.hpp"

namespace hsp {

// Of such a circle, in units of p: above the distance within which vertices count as one point (probe_caps.hpp).
inline constexpr double radius_of_touching = 0x1p-23;

// The unit vector from the point where two of its balls touch to the vertex. 0 for all other vertices, and where the
// third ball alone covers the rest of the circle: then the patch has no area.
Vec3 way_off_touching_point(const BallSet &balls, const Boundary &boundary, uint32_t vertex);

// The slot of the third ball of a vertex of which two balls touch from outside, in that very point; 3 for all others.
uint32_t third_of_touching(const BallSet &balls, const Boundary &boundary, uint32_t vertex);

Position position_of_probe(const BallSet &balls, const Boundary &boundary, uint32_t vertex);

}  // namespace hsp
