// Decimal numbers in IEEE arithmetic: the powers of ten that are doubles, and rounding to integers.
#pragma once

#include <cstdint>

#include "lanes/floating_point.hpp"

namespace hsp {

// All powers of ten up to 10^22 are exact as doubles.
inline constexpr int largest_power_of_ten = 22;
constexpr double power_of_ten[largest_power_of_ten + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                           1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                           1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Nearest integer, halves away from zero, for |x| < 2^62. The double just below one half is added. With it the double
// just below one half stays below 1, and one half becomes 1, as the sum lies halfway between 1 and the double before
// it. The same holds between any two integers.
inline int64_t nearest(double x) {
  return static_cast<int64_t>(x + __builtin_copysign(0x1.fffffffffffffp-2, x));  // no call at -O0
}

// The next integer below, if it is none, for |x| < 2^62.
inline int64_t floor_of(double x) {
  const int64_t truncated = static_cast<int64_t>(x);
  return truncated - static_cast<int64_t>(static_cast<double>(truncated) > x);
}

}  // namespace hsp
