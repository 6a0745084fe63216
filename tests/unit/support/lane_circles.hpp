// Circles that caps cover (sphere/covered_circles_avx2.hpp), compiled for AVX2 apart from the test.
#pragma once

#include <cstdint>

// Caps in arrays; of circles there are sixteen.
struct FloatCapArrays {
  const float *x, *y, *z, *b;
};

// A bit for each circle that the caps certainly cover.
uint32_t covered_circles(const FloatCapArrays &circles, const FloatCapArrays &caps, uint32_t count);
