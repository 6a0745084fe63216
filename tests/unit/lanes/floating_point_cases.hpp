// The numbers that count as finite, and the constants.
#pragma once

#include "cases.hpp"
#include "lanes/floating_point.hpp"

namespace cases {

struct Finite {
  double x;
  bool finite;
};
constexpr Finite finite_numbers[] = {{0.0, true},
                                     {-0.0, true},
                                     {0x1p-1074, true},
                                     {0x1.fffffffffffffp1023, true},
                                     {-0x1.fffffffffffffp1023, true},
                                     {std::numeric_limits<double>::infinity(), false},
                                     {-std::numeric_limits<double>::infinity(), false},
                                     {std::numeric_limits<double>::quiet_NaN(), false}};

inline uint32_t finite_numbers_are_told_from_others() {
  return first_failing(finite_numbers, [](const Finite &c) { return hsp::is_finite(c.x) == c.finite; });
}

inline uint32_t constants_are_nearest() {
  // 1 + u rounds to even, down to 1; anything above rounds up. pi by Machin's formula in integers of 2^-60.
  const auto arc_cotangent = [](int64_t n) {
    int64_t power = (INT64_C(1) << 60) / n, sum = power;
    for (int64_t k = 3; power != 0; k += 2) {
      power /= -(n * n);
      sum += power / k;
    }
    return sum;
  };
  const int64_t quarter = 4 * arc_cotangent(5) - arc_cotangent(239);  // pi / 4
  const double scaled_error = hsp::pi * 0x1p58 - static_cast<double>(quarter);
  volatile double one = 1.0;
  const bool conditions[] = {one + hsp::unit_roundoff == 1.0, one + hsp::unit_roundoff * 1.0000001 > 1.0,
                             near(scaled_error, 0.0, 0x1p7)};  // half an ulp of pi and the formula's few units
  return first_false(conditions);
}

inline constexpr Check lanes_floating_point[] = {
    {"finite_numbers_are_told_from_others", finite_numbers_are_told_from_others},
    {"constants_are_nearest", constants_are_nearest}};

}  // namespace cases
