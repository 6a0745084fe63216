// The order of balls from back to front, by integers of any size.
#pragma once

#include <array>
#include <cstdint>

#include "big_integer.hpp"
#include "lattice_ball.hpp"
#include "view_run.hpp"

// A direction as the header describes it: rounded to integers of which the largest is 2^28. Zeros mean 0 0 1.
std::array<int64_t, 3> integer_direction(const Direction &towards);

// Whether ball a is farther than ball b: the smaller product with the direction; of equal ones, the ball that comes
// first by (x, y, z, radius).
bool is_farther(const oracle::LatticeBall &a, const oracle::LatticeBall &b, const std::array<int64_t, 3> &direction);
