// The boundary of a union of balls by brute force: every triple of balls is tried for vertices, every pair for arcs.
#pragma once

#include "boundary_record.hpp"
#include "lattice_ball.hpp"

namespace oracle {

// The boundary of the balls inflated by infinitesimals as in sphere_predicates.hpp. Cost: at least n^4 for n balls
// that all meet. Throws std::logic_error where the result would contradict itself (an arc seen from one ball only, a
// vertex without three arcs, an open loop, more shells missing than components allow): that is a bug of the oracle.
BoundaryRecord brute_boundary(const Balls &balls);

}  // namespace oracle
