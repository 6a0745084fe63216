// View directions from rotations of the balls, in degrees.
#pragma once

#include "core/elementary.hpp"
#include "view/view_frame.hpp"

namespace hsp {

// Largest |angle| of a rotation, in degrees.
inline constexpr double largest_rotation = 1e6;

// The unit vector of an angle; quarter turns are exact.
SinCos direction_of_degrees(double degrees);

// How balls are seen that are turned about the viewer's x axis, then y, then z. Status::not_finite or Status::range for
// an angle that is not a number or beyond largest_rotation.
Status direction_of_rotation(double x, double y, double z, ViewDirection &direction);

}  // namespace hsp
