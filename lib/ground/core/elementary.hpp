// Elementary functions in plain IEEE arithmetic, so that nothing but sqrt comes from the platform: the C libraries in
// use differ in the last bit of their transcendental functions, even between processors of one family.
#pragma once

#include "lanes/floating_point.hpp"

namespace hsp {

// Largest error of arc_tangent in units in the last place. Derivation in lanes/angle.hpp;
// tests/unit/core/elementary_test.cpp measures it against a longer format.
inline constexpr double arc_tangent_max_ulp = 2.0;

// The angle of the point (x, y), in [-pi, pi], with the same bits as in lanes. The arguments are those of the C
// function atan2, but the sign of a zero does not matter, and at (0, 0) the result is 0.
double arc_tangent(double y, double x);

// An angle closer than this to 0 or 2 pi is taken from exact integers: rounding must not turn a point into a whole
// circle or back. Angles computed in doubles have a far smaller error.
inline constexpr double branch_cut_margin = 0x1p-20;

// Largest absolute error of each component of sin_cos, in units of 2^-53. Its derivation is at the definition.
inline constexpr double sin_cos_max_error = 3.0;

// Largest |angle| that sin_cos takes.
inline constexpr double largest_angle = 0x1p20;

// The point of the unit circle at an angle.
struct SinCos {
  double cosine, sine;
};
SinCos sin_cos(double angle);

}  // namespace hsp
