// Computes areas and volume a second way, from the positions of vertices instead of exact integers. The tolerances are
// bounds of rounding; they decide only whether the two ways agree.
#pragma once

#include "boundary/boundary_check.hpp"

namespace hsp {

// Checks invariants 9 to 11 of BoundaryInvariant. O(size).
BoundaryViolation check_boundary_metric(const BallSet &balls, const Boundary &boundary);

}  // namespace hsp
