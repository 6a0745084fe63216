// The error bounds with which two caps and their crossing points are decided, in doubles (cap_pair.hpp, where they are
// derived) and in floats, for the code that does so in lanes.
//
// In floats, with e = 2^-24 and u 6.5, b 29 from float_caps.hpp, first order, |b| <= 1, q <= S <= 1; a product is
// rounded before it is added, or not, where the target fuses them:
//   g         2 * 6.5 + 3                                                                                16
//   q         1 - b_j^2: 60; g^2: 34; b_k^2: 61; 2 g b_j b_k: 2 (16 + 29 + 29) + 4; last addition: 1     308
//   b_j - g b_k    29 + 29 + 16 + 2                                                                      76
//   S         2 * 16 + 2                                                                                 34
// The points, as in cap_pair.hpp with s = 1/S:
//   alpha, beta    2 (76 s + 34 s sqrt(s) + 4 sqrt(s)),  u: 13 sqrt(s)
//   gamma          154 s/sqrt(q) + 34 s sqrt(s) + 5 sqrt(s),  cross product: 16 sqrt(s),  additions: 2 sqrt(s) + 3
//   a test         6.5 + 29 + 7 more
// As s >= 1, all stays below e s (346 s + 154/sqrt(q)); used are 512 and 240. With q > 2^-12 the relative errors of q
// and S are below 0.076 and 0.009, which raise 154 by less than a tenth; what is left of the slack absorbs terms in e^2
// and the rounding of the bound.
#pragma once

#include "lanes/floating_point.hpp"

namespace hsp {

// Below this the pair is left to the exact stage; 111 e is far smaller.
inline constexpr double certain_discriminant = 0x1p-32;
// For the centre of one circle against the other cap, g b_j - b_k: error at most 10 + 7 + 1 + 7 + 2 units.
inline constexpr double certain_centre = 32 * unit_roundoff;

// For floats and doubles alike.
template <class Real>
struct CapPairBounds;
template <>
struct CapPairBounds<double> {
  static constexpr double roundoff = unit_roundoff;
  static constexpr double crossing = certain_discriminant;  // of q, for whether the circles cross
  static constexpr double points = certain_discriminant;    // of q, for where they cross
  static constexpr double centre = certain_centre;
  static constexpr double point_s = 256.0, point_root = 80.0;  // e s (point_s s + point_root / sqrt(q))
};
template <>
struct CapPairBounds<float> {
  static constexpr float roundoff = 0x1p-24F;
  static constexpr float crossing = 0x1p-15F;  // 512 e
  static constexpr float points = 0x1p-12F;
  static constexpr float centre = 0x1p-17F;  // 128 e
  static constexpr float point_s = 512.0F, point_root = 240.0F;
};

}  // namespace hsp
