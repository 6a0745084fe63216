// Finds the first ball on a ray in any direction.
#pragma once

#include "core/vec3.hpp"
#include "exact/ray_order.hpp"
#include "model/cube_grid.hpp"

namespace hsp {

// Rounds the origin to the lattice of the balls, and the direction, times a power of two, to integers below 2^53: the
// error of a component is at most 2^-53 of the largest component. Status::range also for a direction of length 0.
Status round_ray(const BallSet &balls, const double *origin, const double *direction, exact::LatticeRay &ray);

// Lengths in lattice steps.
struct RayHit {
  uint32_t ball;    // in grid order; no_id if there is none: then nothing else is known
  double distance;  // from the ray's origin to the point; 0 if the origin lies in the ball
  Vec3 point;
};

// The closed ball that the ray meets first; of several balls met first in one point, the one with the lowest index in
// the caller's order. The ball is decided exactly. The search looks at the layers of cubes across the ray's longest
// axis, as far as the ray is within reach of the box around all cubes, until no further layer can hold an earlier ball:
// at up to 16 cubes of a layer. If there are more layers than cubes, it looks at all balls.
RayHit first_ball_on_ray(const CubeGrid &grid, const exact::LatticeRay &ray);

}  // namespace hsp
