// Which circles of caps are certainly covered by other caps, in fractions. Nothing on such a circle is free, so that
// none of its pairs has to be looked at. Most circles of a ball with many caps are such.
//
// A circle is cut into eight arcs of 45 degrees, and is covered if each arc lies inside one of the caps. With u, b the
// cap of the circle, v, c another one, E and F unit vectors across u and each other, and r = sqrt(1 - b^2), the depth
// of the circle's point at angle t in the other cap is d(t) = A + X cos t + Y sin t with A = b u.v - c, X = r E.v and
// Y = r F.v. It is known to within 18 f, with f = 2^-15, by what fractions are known to (below), and with
// e = 2^-24:
//   r E, r F     E, F: u has a length within 11 e of 1 and is 11 e from the true one; they turn with u no more than
//                three times as far; 1 / (1 + |z|) is known to 3 e: 38 e; r for 1 - b^2 > 2^-8, so that r > 2^-4:
//                60 e / (2 r) + e < 481 e; rounded by f / 2                                                   1.6
//   A                                                                                                         7.5
//   X, Y         2.6 sqrt(3) + 1.5                                                                              6
//   X cos t, Y sin t   at eighths of a turn: 6 / sqrt(2) + 0.3 by the constant + 0.5 < 5.1, for both         10.2
//
// If d exceeds a margin of 32 f at both ends of an arc and its least value is at one of them, the arc lies inside the
// cap. The least value is between the ends only if the direction t where X cos t + Y sin t = -B, B its largest value,
// is; then the nearer end is no more than 22.5 degrees from it, and there d <= A - 0.9238 B. To exclude that, A is
// lowered to 0.92 max(|X|, |Y|) <= 0.92 B + 6.4 f where it is larger, which makes no d larger: then what is computed
// there is at most 6.4 f - 0.0038 B + 10.2 f, which is below the margin.
//
// Asked for are caps with c <= 7/8. Where A stops at 1 it is lowered. Where it stops at -1, the margin is lost; but
// then |b u.v| >= 1/8 and B <= 1 - |b u.v|, so that no d seems positive.
//
// Fractions are twice as many at once as floats. With f = 2^-15 their step: u and b of circles, v and c of caps are
// rounded by f / 2, or 1 is taken for 1 - f; 6.5 e and 29 e are less than 0.1 f more (float_caps.hpp): they are known
// to f. So that no dot product becomes -1, u is shortened by a factor; so are all depths, of which only signs are asked
// for, if c is, while v and b are what they are. A dot product of vectors of at most length 1, with components known to
// p f and q f, is known to sqrt(3) (p + q) f and three times f / 2; no sum is larger than 1, so that one that stops
// there is not made worse by that:
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

class CoveredArcs {
 public:
  using SomeCaps = LaneCaps<Floats>;

  // As many circles as there are fractions.
  CoveredArcs(const SomeCaps &low, const SomeCaps &high) : CoveredArcs(low, high, Frames(low), Frames(high)) {}

  // One more cap that may cover arcs of them.
  void cover(const FractionCap &cap) {
    const Fractions x = cap.dot(e_), y = cap.dot(f_);
    const Fractions most = larger(magnitude(x), magnitude(y)) * Fractions::all(0.92F);
    const Fractions a = smaller(cap.dot(circles_.u) * circles_.b - cap.b, most) - Fractions::all(0x1p-10F);
    const Fractions eighth = Fractions::all(0.70710678F), sx = x * eighth, sy = y * eighth;
    const Fractions end[4] = {x, sx + sy, y, sy - sx};
    // Arcs k and k + 4 side by side.
    FractionSigns before = FractionSigns::of(a + x, a - x);
    for (int k = 0; k < 4; ++k) {
      const FractionSigns after =
          k < 3 ? FractionSigns::of(a + end[k + 1], a - end[k + 1]) : FractionSigns::of(a - x, a + x);
      open_[k] = both_negative(open_[k], either_negative(before, after));
      before = after;
    }
  }

  // The circles that are covered as a whole.
  struct Covered {
    LaneBits low, high;
  };
  Covered covered() const {
    FractionSigns any = open_[0];
    for (int k = 1; k < 4; ++k) any = either_negative(any, open_[k]);
    LaneBits low = 0, high = 0;
    any.negative(low, high);
    return {wide_low_ & ~low, wide_high_ & ~high};
  }

 private:
  // r E and r F of circles.
  struct Frames {
    Floats ex, ey, ez, fx, fy, fz;
    LaneBits wide;

    explicit Frames(const SomeCaps &circles) {
      // Across u = (x, y, z), with s the sign of z, a = -1 / (s + z) and p = x y a (Duff et al., Building an
      // Orthonormal Basis, Revisited, JCGT 6 (1), 2017): E = (1 + s x^2 a, s p, -s x) and F = (p, s + y^2 a, -y).
      const Floats one = Floats::all(1.0F);
      const Floats s = with_sign_of(one, circles.z);
      const Floats a = -(one / (s + circles.z));
      const Floats p = circles.x * circles.y * a;
      const Floats squared = minus_fused(circles.b, circles.b, one);
      const Floats r = square_root(squared);
      wide = greater(squared, Floats::all(0x1p-8F));
      ex = r * fused(s * circles.x, circles.x * a, one);
      ey = r * s * p;
      ez = -(r * s * circles.x);
      fx = r * p;
      fy = r * fused(circles.y, circles.y * a, s);
      fz = -(r * circles.y);
    }
  };

  static Fractions both(Floats low, Floats high) { return Fractions::of(low, high, fraction_factor); }
  CoveredArcs(const SomeCaps &low, const SomeCaps &high, const Frames &first, const Frames &last)
      : circles_(low, high),
        e_{both(first.ex, last.ex), both(first.ey, last.ey), both(first.ez, last.ez)},
        f_{both(first.fx, last.fx), both(first.fy, last.fy), both(first.fz, last.fz)},
        wide_low_(first.wide),
        wide_high_(last.wide) {
    for (FractionSigns &open : open_) open = FractionSigns::all_negative();
  }

  FractionCircles circles_;
  LaneFractions e_, f_;  // r E and r F
  LaneBits wide_low_, wide_high_;
  FractionSigns open_[4];  // negative for arcs that no cap has covered so far
};

}  // namespace
}  // namespace hsp
