// The cap that cuts a chord first, as kernels for registers of several widths find it in doubles.
//
// The chord runs along m + s w on the unit sphere, from s = -1 to 1, and something cuts it. With f = u.m - b and
// g = u.w a cap is entered at s = -f/g where g > 0. Errors of f and g together are below E <= most_error (cap_pair.hpp,
// UnitChord). So where g > least_slope and s <= 2 the quotient is off by at most (E + 2 E)/(g - E) and its rounding,
// together less than 4 E/least_slope; and what is found beyond 2 lies beyond 1.9. Numbers of caps take the place of the
// last 16 bits of s + 64, where all that lies before -60 is taken for -60: from 4 to 68, so that no number is lost with
// a subnormal one that a processor takes for 0. That makes s less exact by 2^-30. Where |g| <= least_slope a cap cuts
// nothing up to s = 1 if -f is more than that; the others, and some with twice the slope, are not decided. The chord's
// own two are among them.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

struct CapColumns {
  const double *ux, *uy, *uz, *b;  // readable to the end of a register behind the last

  static constexpr double least_slope = 0x1p-16;
  static constexpr double most_error = 0x1p-32;
  static constexpr uint32_t most_caps = 1U << 16;
  static constexpr double none = 4.0;  // no cap cuts the chord as far as it is looked at
  static constexpr double start = -60.0, shift = 64.0;
};

inline constexpr uint32_t no_cut = ~UINT32_C(0);

// Among caps [first, last), fewer than most_caps, the one that cuts the chord of caps j and k of them on the way from
// the side of p- to that of p+, or the other way if direction is -1 instead of 1; no_cut if that is not certain.
HSP_KERNEL(uint32_t, nearest_cut,
           (const CapColumns &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k, double direction),
           (caps, first, last, j, k, direction))

}  // namespace hsp
