// Where points of one sphere lie on its loops and faces.
#pragma once

#include "boundary/boundary.hpp"
#include "sphere/gathered_ball.hpp"

namespace hsp {

// The arc or free circle of ball caps.origin on which the circle of a cap crosses another circle in a free point; sign
// as seen from that other circle, so that seen from the cap it is the opposite one.
LoopElement locate_on_boundary(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                               uint32_t cap, const exact::Plane &other, int sign);

// The face that contains the highest point of ball i, which must be free. The ball's caps are gathered if it has
// several faces.
uint32_t face_of_top(const CubeGrid &grid, const Boundary &boundary, uint32_t i, GatheredBall &gathered);

// The face in which a vertical line through (x, y) enters ball i from below; that point must be free.
uint32_t face_of_entry(const CubeGrid &grid, const Boundary &boundary, uint32_t i, int64_t x, int64_t y,
                       GatheredBall &gathered);

}  // namespace hsp
