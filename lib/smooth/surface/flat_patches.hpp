// Vertices in the plane of their balls' centres, where two circles touch: little or nothing is left of their patches.
#pragma once

#include "surface/probe_grid.hpp"

namespace hsp {

// Whether a vertex, at a position, lies in the plane of its balls' centres up to rounding; then the plane's normal on
// the vertex's side.
bool is_flat(const BallSet &balls, const Boundary &boundary, const Position &position, uint32_t vertex, Vec3 &normal);

}  // namespace hsp
