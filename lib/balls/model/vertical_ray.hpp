// The first ball that a vertical ray upwards enters.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

// The ball, in the grid's order, that the upward ray from `start` enters first; no_id if it enters none. The start must
// lie in no closed ball. Of several balls entered in one point it is the one that the symbolic perturbation makes
// the first. highest_centre is the largest z of all centres.
uint32_t first_ball_above(const CubeGrid &grid, const exact::Vector &start, int64_t highest_centre);

}  // namespace hsp
