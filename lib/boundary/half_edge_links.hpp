// From vertices, each decided once, to loops: every vertex starts a half-edge on each of its three balls, and each
// half-edge finds the one that follows it.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Fills half-edges, closed half-edges and loops from vertices and circles. scratch [balls].
void link_half_edges(const BallSet &balls, BoundaryArrays &boundary, Span<uint32_t> scratch);

}  // namespace hsp
