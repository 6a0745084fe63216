// Which face of a ball holds a given point of its sphere: its highest point, or the point where a vertical line enters
// it. The ball's caps are gathered if it has several faces.
#pragma once

#include "boundary/boundary.hpp"
#include "sphere/gathered_ball.hpp"

namespace hsp {

// The face that holds the highest point of ball i, which must be free.
uint32_t face_of_top(const CubeGrid &grid, const BoundaryStructure &boundary, uint32_t i, GatheredBall &gathered);

// The face in which a vertical line through (x, y) enters ball i from below; that point must be free.
uint32_t face_of_entry(const CubeGrid &grid, const BoundaryStructure &boundary, uint32_t i, int64_t x, int64_t y,
                       GatheredBall &gathered);

}  // namespace hsp
