// Elementary functions in plain IEEE arithmetic, so that nothing but sqrt comes from the platform: the C libraries in
// use differ in the last bit of their transcendental functions, even between processors of one family.
#pragma once

#include "core/floating_point.hpp"

namespace hsp {

// Largest error of arc_tangent in units in the last place. Derivation beside the definition;
// tests/inner/elementary_test.cpp measures it against a longer format.
inline constexpr double arc_tangent_max_ulp = 2.0;

// The angle of the point (x, y), in [-pi, pi]. Differs from the C function only at (0, 0), where the result is 0 for
// either sign of the zeros.
double arc_tangent(double y, double x);

// Largest absolute error of each component of direction_of, in units of 2^-53. Derivation beside the definition.
inline constexpr double direction_max_error = 3.0;

// Largest |angle| that direction_of takes.
inline constexpr double largest_angle = 0x1p20;

// The point of the unit circle at an angle.
struct Direction {
  double cosine, sine;
};
Direction direction_of(double angle);

}  // namespace hsp
