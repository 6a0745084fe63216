// Powers of ten, and rounding to integers at halves and at the ends of the range.
#pragma once

#include "cases.hpp"
#include "core/decimal.hpp"

namespace cases {

struct Rounded {
  double x;
  int64_t nearest;
};
constexpr Rounded rounded[] = {{0.0, 0},
                               {-0.0, 0},
                               {0.25, 0},
                               {0.5, 1},
                               {-0.5, -1},
                               {0x1.fffffffffffffp-2, 0},
                               {1.5, 2},
                               {2.5, 3},
                               {-1.5, -2},
                               {-2.5, -3},
                               {-2.4999, -2},
                               {1e15 + 0.5, 1000000000000001},
                               {-2.4, -2},
                               {0x1p52, INT64_C(1) << 52},
                               {0x1p52 + 1, (INT64_C(1) << 52) + 1},
                               {0x1p51 + 0.5, (INT64_C(1) << 51) + 1},
                               {-0x1p51 - 0.5, -(INT64_C(1) << 51) - 1},
                               {0x1.fffffffffffffp61, (INT64_C(1) << 62) - (INT64_C(1) << 9)},
                               {-0x1.fffffffffffffp61, (INT64_C(1) << 9) - (INT64_C(1) << 62)}};

inline uint32_t rounds_halves_away_from_zero() {
  return first_failing(rounded, [](const Rounded &c) { return hsp::nearest(c.x) == c.nearest; });
}

// 10^k = 2^k 5^k is a double while 5^k has at most 53 bits: built from integers, k by k.
inline uint32_t powers_of_ten_are_exact() {
  uint64_t power_of_five = 1;
  double power_of_two = 1.0;
  for (uint32_t k = 0; k <= static_cast<uint32_t>(hsp::largest_power_of_ten); ++k) {
    if (hsp::power_of_ten[k] != static_cast<double>(power_of_five) * power_of_two) return k;
    if (power_of_five >> 53 != 0) return k;
    power_of_five *= 5;
    power_of_two *= 2;
  }
  // The next one is no double.
  return power_of_five >> 53 != 0 ? all_hold : static_cast<uint32_t>(hsp::largest_power_of_ten) + 1;
}

inline constexpr Check core_decimal[] = {{"rounds_halves_away_from_zero", rounds_halves_away_from_zero},
                                         {"powers_of_ten_are_exact", powers_of_ten_are_exact}};

}  // namespace cases
