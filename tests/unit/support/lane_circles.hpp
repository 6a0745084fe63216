// Circles that caps cover (sphere/covered_circles.hpp), a kernel apart from the test.
#pragma once

#include "lanes/target.hpp"

namespace hsp {

// Caps in arrays; as `circles` there are always sixteen.
struct FloatCapArrays {
  const float *x, *y, *z, *b;
};

// A bit for each circle that the caps certainly cover.
HSP_KERNEL(uint32_t, covered_circles, (const FloatCapArrays &circles, const FloatCapArrays &caps, uint32_t count),
           (circles, caps, count))

}  // namespace hsp
