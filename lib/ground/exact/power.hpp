// The power of a point to a sphere, |d|^2 - r^2 with d from the centre to the point: negative inside, positive outside.
// Exact for |d_k|, r < 2^62.
#pragma once

#include "exact/plane.hpp"
#include "exact/wide_integer.hpp"

namespace hsp::exact {

inline WideInteger<FastLimb, 128> square(int64_t a) {
  const auto wide = WideInteger<FastLimb, 64>::from(a);
  return product<128>(wide, wide);
}

inline WideInteger<FastLimb, 128> squared_length(const Vector &d) {
  return square(d.x) + square(d.y) + square(d.z);
}

inline WideInteger<FastLimb, 128> power(const Vector &d, int64_t radius) {
  return squared_length(d) - square(radius);
}

}  // namespace hsp::exact
