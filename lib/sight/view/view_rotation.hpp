// View directions from rotations of the balls, in degrees.
#pragma once

#include "core/elementary.hpp"
#include "view/view_frame.hpp"

namespace hsp {

// Largest |angle| of a rotation, in degrees.
inline constexpr double largest_rotation = 1e6;

// The unit vector of an angle; quarter turns are exact.
SinCos direction_of_degrees(double degrees);

// The direction in which balls look as if they were turned about the viewer's x axis, then y, then z.
// Status::not_finite for an angle that is not finite, Status::range for one beyond largest_rotation.
Status direction_of_rotation(double x, double y, double z, ViewDirection &direction);

}  // namespace hsp
