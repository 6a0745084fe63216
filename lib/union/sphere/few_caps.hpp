// The search of a ball with few caps, as on van der Waals surfaces: all pairs of caps at once, as bits of words, which
// give vertices, free circles and clusters together.
#pragma once

#include "lanes/target.hpp"

namespace hsp {

inline constexpr uint32_t most_few_caps = 16;

// One of the two points where the circles of caps j < k cross: p+ if `positive` is 1, p- if it is 0.
struct FreePoint {
  uint8_t j, k;
  uint8_t positive;
};

struct FewCaps {
  uint32_t clusters;      // number
  uint32_t free_circles;  // bit k is for cap k, of later caps alone
  uint32_t crossing;      // number of pairs of later caps whose circles cross
  uint32_t points;        // number of free points of two later caps, which follow in the order of j, k and sign
  FreePoint point[most_few_caps * (most_few_caps - 1) + 1];
};

// False if not everything is certain; `found` then means nothing. The arrays can be read up to eight caps, or sixteen
// if there are more than eight, and nothing lies in the caps behind the last one. Later caps begin at first_later.
HSP_KERNEL(bool, find_few_in_floats,
           (const float *x, const float *y, const float *z, const float *b, uint32_t count, uint32_t first_later,
            FewCaps &found),
           (x, y, z, b, count, first_later, found))
// Always false where registers hold two doubles: the loops of VertexFinder are no slower.
HSP_KERNEL(bool, find_few_in_doubles,
           (const double *x, const double *y, const double *z, const double *b, uint32_t count, uint32_t first_later,
            FewCaps &found),
           (x, y, z, b, count, first_later, found))

}  // namespace hsp
