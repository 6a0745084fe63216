// Areas and volume once more, from the positions of vertices instead of exact integers. The tolerances are those of
// rounding; they decide nothing but whether the two ways agree.
#pragma once

#include "boundary/boundary_check.hpp"

namespace hsp {

// Invariants 9 to 11. O(size).
BoundaryViolation check_boundary_metric(const BallSet &balls, const Boundary &boundary);

}  // namespace hsp
