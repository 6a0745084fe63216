// Finds the first ball that a vertical ray upwards enters.
//
// As an example the ray from (0,0,7), and balls of radius 5 at (3,0,20) and (0,4,18): it would enter them at 20 - 4 =
// 16 and at 18 - 3 = 15, so that the second one is the first that it enters.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

// The ball, in grid order, that the upward ray from `start` enters first; no_id if it enters none. `start` must lie in
// no closed ball. Of several balls entered in one point it is the one that comes first by the symbolic perturbation.
// highest_centre: the largest z of all centres.
uint32_t first_ball_above(const CubeGrid &grid, const exact::Vector &start, int64_t highest_centre);

}  // namespace hsp
