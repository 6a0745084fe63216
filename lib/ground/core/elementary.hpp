// Elementary functions in plain IEEE arithmetic, so that nothing but sqrt comes from the platform: the C libraries in
// use differ in the last bit of their transcendental functions, even between processors of one family.
#pragma once

#include "lanes/floating_point.hpp"

namespace hsp {

// atan(k/8), the sum of two doubles.
struct EighthTangent {
  double tangent, high, low;
};
constexpr EighthTangent eighth_tangents[9] = {
    {0.0, 0x0.0p+0, 0x0.0p+0},
    {0.125, 0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0.25, 0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0.375, 0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0.5, 0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0.625, 0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0.75, 0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0.875, 0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {1.0, 0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

// Largest error of arc_tangent in units in the last place. Derivation beside the definition;
// tests/unit/core/elementary_test.cpp measures it against a longer format.
inline constexpr double arc_tangent_max_ulp = 2.0;

// The angle of the point (x, y), in [-pi, pi]. Differs from the C function only at (0, 0), where the result is 0 for
// either sign of the zeros.
double arc_tangent(double y, double x);

// An angle closer than this to 0 or 2 pi is taken from exact integers: rounding must not turn a point into a
// whole circle or back. Numbers computed in doubles have a far smaller error.
inline constexpr double branch_cut_margin = 0x1p-20;

// Largest absolute error of each component of sin_cos, in units of 2^-53. Derivation beside the definition.
inline constexpr double sin_cos_max_error = 3.0;

// Largest |angle| that sin_cos takes.
inline constexpr double largest_angle = 0x1p20;

// The point of the unit circle at an angle.
struct SinCos {
  double cosine, sine;
};
SinCos sin_cos(double angle);

}  // namespace hsp
