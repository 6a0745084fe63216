// Caps and circles as fractions, twice as many circles at once as in floats, for what need not be sharp: which circles
// certainly lie in caps.
//
// With f = 2^-15 the step of fractions: u and b of circles, v and c of caps are rounded by f / 2, or 1 is taken for
// 1 - f; 6.5 e and 29 e with e = 2^-24 are less than 0.1 f more (float_caps.hpp): they are known to f. So that no dot
// product becomes -1, u is shortened by a factor; so are all depths, of which only signs are asked for, if c is, while
// v and b are what they are. A dot product of vectors of at most length 1, with components known to p f and q f, is
// known to sqrt(3) (p + q) f and three times f / 2; no sum is larger than 1, so that one that stops there is not made
// worse by that:
//   u.v         2 sqrt(3) + 1.5                5
//   b u.v       1 + 5 + 0.5                    6.5
//   b u.v - c   1 more                         7.5
#pragma once

#include "sphere/crossing_pairs.hpp"

namespace hsp {
namespace {

constexpr float fraction_factor = 1.0F - 0x1p-10F;

// Vectors at most as long as fraction_factor.
struct LaneFractions {
  Fractions x, y, z;
};

// Caps as fractions that each stand there twice.
inline void store_as_fractions(const LaneCaps<Floats> &caps, float *x, float *y, float *z, float *b) {
  Fractions::twice(caps.x, 1.0F).store(x);
  Fractions::twice(caps.y, 1.0F).store(y);
  Fractions::twice(caps.z, 1.0F).store(z);
  Fractions::twice(caps.b, fraction_factor).store(b);
}

// One of them.
struct FractionCap {
  Fractions x, y, z, b;

  static FractionCap all_of(const CapPointers<float> &caps, uint32_t k) {
    return {Fractions::all_of(caps.x + k), Fractions::all_of(caps.y + k), Fractions::all_of(caps.z + k),
            Fractions::all_of(caps.b + k)};
  }
  Fractions dot(const LaneFractions &a) const { return a.x * x + a.y * y + a.z * z; }
};

// As many circles as there are fractions.
struct FractionCircles {
  LaneFractions u;
  Fractions b;

  FractionCircles(const LaneCaps<Floats> &low, const LaneCaps<Floats> &high)
      : u{Fractions::of(low.x, high.x, fraction_factor), Fractions::of(low.y, high.y, fraction_factor),
          Fractions::of(low.z, high.z, fraction_factor)},
        b(Fractions::of(low.b, high.b, 1.0F)) {}
};

}  // namespace
}  // namespace hsp
