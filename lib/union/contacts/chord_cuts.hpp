// The cap that cuts a chord first, as kernels for registers of several widths find it in doubles.
//
// The chord runs along m + s w on the unit sphere, from s = -1 to 1, and something cuts it. With f = u.m - b and
// g = u.w a cap is entered at s = -f/g where g > 0. Errors of f and g together are below E <= most_error (UnitChord).
// So where g > least_slope and s <= 2 the quotient is off by at most (E + 2 E)/(g - E) and its rounding, together less
// than 4 E/least_slope; and what is found beyond 2 lies beyond 1.9. Numbers of caps take the place of the last 16 bits
// of quotients: these are off by 2^-35 more. Where |g| <= least_slope a cap cuts nothing up to s = 1 if -f is more
// than that; the others, and some with twice the slope, are not decided.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

struct CapColumns {
  const double *ux, *uy, *uz, *b;  // readable to the end of a register behind the last
};

struct ChordRay {
  double m[3], w[3];
  double error;  // E

  static constexpr double least_slope = 0x1p-16;
  static constexpr double most_error = 0x1p-32;
  static constexpr uint32_t most_caps = 1U << 16;
  static constexpr double none = 4.0;     // no cap cuts it as far as it is looked at
  static constexpr double nowhere = 8.0;  // the b of a cap that is left out, as the chord's own two
};

// Among caps [first, last), fewer than most_caps; no_cut if it is not certain.
inline constexpr uint32_t no_cut = ~UINT32_C(0);
HSP_KERNEL(uint32_t, nearest_cut, (const CapColumns &caps, uint32_t first, uint32_t last, const ChordRay &ray),
           (caps, first, last, ray))

}  // namespace hsp
