// The first ball on a ray in any direction.
#pragma once

#include "core/vec3.hpp"
#include "exact/ray_order.hpp"
#include "model/cube_grid.hpp"

namespace hsp {

// Rounds the origin to the lattice of the balls, and the direction, times a power of two, to integers below 2^53: what
// that leaves off is at most 2^-53 of its largest component. Status::range also for a direction of length 0.
Status round_ray(const BallSet &balls, const double *origin, const double *direction, exact::LatticeRay &ray);

// Lengths in lattice steps.
struct RayHit {
  uint32_t ball;    // in the grid's order; no_id: none, and nothing else is known
  double distance;  // of the point from the ray's origin; 0 if that lies in the ball
  Vec3 point;
};

// The closed ball that the ray meets first, of several in one point the one with the lowest number of the caller's.
// Which ball it is is decided exactly. Looks at the layers of cubes across the ray's longest axis, as far as the ray is
// within reach of the box around all cubes, until none can hold an earlier ball: up to 16 cubes of a layer, but if
// there are more layers than cubes at all balls.
RayHit first_ball_on_ray(const CubeGrid &grid, const exact::LatticeRay &ray);

}  // namespace hsp
