// Angles of four directions in lanes (lanes/angle.hpp), a kernel apart from the test.
#pragma once

#include "lanes/target.hpp"

namespace hsp {

// The angles by half_turn_angle, four at a time, and by turn_angle, as many as a register holds.
HSP_KERNEL(void, angles_of_four, (const double *x, const double *y, double *half_turn_angles, double *turn_angles),
           (x, y, half_turn_angles, turn_angles))

}  // namespace hsp
