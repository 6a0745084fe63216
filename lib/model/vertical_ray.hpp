// The first ball that a vertical ray upwards enters.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

// The ball whose sphere the ray from `start`, a point in no closed ball, enters first, in the grid's order; no_id if it
// meets none. Of balls that it enters in one point it is the one of lowest rank, which the symbolic inflation makes the
// first. highest_centre is the largest z of all centres.
uint32_t first_ball_above(const CubeGrid &grid, const exact::Vector &start, int64_t highest_centre);

}  // namespace hsp
