// Kernels for registers of several widths, which find the cap that cuts a chord first, in doubles or in floats.
//
// The chord runs along m + s w on the unit sphere, from s = -1 to 1. Some cap cuts it, and no cap holds all of it. With
// f = u.m - b and g = u.w, a cap cuts the chord iff it holds the end at 1 and not that at -1: iff g > |f|. It does so
// at s = -f/g. Errors of f and g together are below E (cap_pair.hpp, LaneChords). Let B be 2 E:
//   g + B <= |f|        the cap does not cut the chord
//   else, and g > 4 B   |s| < 5/4, and s is off by at most 5/4 E/(g - E) < 3/2 E/g: by less than B/g with roundings,
//                       of which E has more than 300
//   else                not decided; this is so for the chord's own two caps, with f = g = 0
// If only these two are not decided, and one cap's s + B/g is less than s - B/g of all others that may cut the chord,
// this cap is the first one: were it beyond 1, so were all others, and nothing would cut the chord.
#pragma once

#include "lanes/target.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {

inline constexpr uint32_t no_cut = ~UINT32_C(0);

// The cap, of caps first .. last - 1, that cuts the chord of caps j and k of these first on the way to p+, if side is
// 1, or to p-, if it is 0; no_cut if that is not certain. Caps behind the last one are read to the end of a register;
// nothing may lie in these. The kernel for floats is there if there are lanes.
HSP_KERNEL(uint32_t, nearest_cut,
           (const CapPointers<double> &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k, uint32_t side),
           (caps, first, last, j, k, side))
HSP_KERNEL(uint32_t, nearest_cut,
           (const CapPointers<float> &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k, uint32_t side),
           (caps, first, last, j, k, side))

}  // namespace hsp
