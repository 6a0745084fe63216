// The cap that cuts a ray along a chord first, as kernels for registers of several widths find it in doubles.
//
// The chord runs along m + s w on the unit sphere, from s = -1 to 1. With f = u.m - b and g = u.w a cap is entered at
// s = -f/g where g > 0. Those with |g| <= least_slope are decided by f alone: they hold the chord's middle and both
// its ends or none of them, or are near to it. Errors of f and g together are below E <= most_error (UnitChord). So
// where g > least_slope and s <= 2 the quotient is off by at most (E + 2 E)/(g - E) and its rounding, together less
// than 4 E/least_slope; and what is found beyond 2 lies beyond 1.9.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

struct CapColumns {
  const double *ux, *uy, *uz, *b;  // readable to the end of a register behind the last
};

struct ChordRay {
  double m[3], w[3];

  static constexpr double least_slope = 0x1p-16;
  static constexpr double most_error = 0x1p-32;
  static constexpr double none = 4.0;  // no cap cuts it as far as it is looked at
};

struct NearestCut {
  double s;          // where the first one does
  double second;     // where the next one does
  uint32_t cap;      // the first one
  uint32_t unclear;  // how many have no slope, and may be near; the chord's own two are among them
};

// Among caps [first, last).
HSP_KERNEL(NearestCut, nearest_cut, (const CapColumns &caps, uint32_t first, uint32_t last, const ChordRay &ray),
           (caps, first, last, ray))

}  // namespace hsp
