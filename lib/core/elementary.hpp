// Elementary functions in plain IEEE arithmetic, so that nothing but sqrt comes from the platform: the C libraries in
// use differ in the last bit of their transcendental functions, even between processors of one family.
#pragma once

#include "core/floating_point.hpp"

namespace hsp {

// Largest error of arc_tangent in units in the last place. Derivation beside the definition;
// tests/unit/core/elementary_test.cpp measures it against a longer format.
inline constexpr double arc_tangent_max_ulp = 2.0;

// The angle of the point (x, y), in [-pi, pi]. Differs from the C function only at (0, 0), where the result is 0 for
// either sign of the zeros.
double arc_tangent(double y, double x);

// Largest absolute error of each component of sin_cos, in units of 2^-53. Derivation beside the definition.
inline constexpr double sin_cos_max_error = 3.0;

// Largest |angle| that sin_cos takes.
inline constexpr double largest_angle = 0x1p20;

// The point of the unit circle at an angle.
struct Direction {
  double cosine, sine;
};
Direction sin_cos(double angle);

}  // namespace hsp
