// Finds in fractions of 16 bits which circles of caps other caps certainly cover, and which circles certainly cross
// another one. Nothing on a covered circle is free, so that none of its pairs has to be looked at. Most circles of a
// ball with many caps are covered.
//
// A circle is cut into eight arcs of 45 degrees, and is covered if each arc lies inside one of the caps. With u, b the
// cap of the circle, v, c another one, E and F unit vectors across u and each other, and r = sqrt(1 - b^2), the depth
// of the circle's point at angle t in the other cap is d(t) = A + X cos t + Y sin t with A = b u.v - c, X = r E.v and
// Y = r F.v. Its error is at most 18 f, with f = 2^-15. This follows from the errors of fractions (below) and, with
// e = 2^-24, of floats:
//   r E, r F     E, F: u has a length within 11 e of 1 and is 11 e from the true one; they turn with u no more than
//                three times as far; 1 / (1 + |z|) is known to 3 e: 38 e; r for 1 - b^2 > 2^-8, so that r > 2^-4:
//                60 e / (2 r) + e < 481 e; rounded by f / 2                                                   1.6
//   A                                                                                                         7.5
//   X, Y         2.6 sqrt(3) + 1.5                                                                              6
//   X cos t, Y sin t   at eighths of a turn: 6 / sqrt(2) + 0.3 by the constant + 0.5 < 5.1, for both         10.2
//
// If d exceeds a margin of 32 f at both ends of an arc, and its least value on the arc is at one of the ends, the arc
// lies inside the cap. Let B be the largest value of X cos t + Y sin t. The least value of d lies between the ends only
// if the t with X cos t + Y sin t = -B does. Then the nearer end is no more than 22.5 degrees from this t, and d there
// is <= A - 0.9238 B. To exclude that, A is lowered to 0.92 max(|X|, |Y|) <= 0.92 B + 6.4 f if it is larger, which
// makes no d larger: the computed d at that end is then at most 6.4 f - 0.0038 B + 10.2 f, below the margin.
//
// The caps that may cover arcs have c <= 7/8. Fractions stop at -1 and at 1. Where A stops at 1 it is lowered anyway.
// Where it stops at -1, the margin is lost; but then |b u.v| >= 1/8 and B <= 1 - |b u.v|, so that no d seems positive.
//
// A register holds twice as many fractions as floats. Their step is f = 2^-15. u and b of circles, v and c of caps are
// rounded by f / 2, or 1 is taken for 1 - f; the errors 6.5 e and 29 e of floats (float_caps.hpp) are less than 0.1 f.
// So each of these has an error of at most f. u is shortened by a factor, so that no dot product becomes -1. With c
// shortened, too, and v and b as they are, all depths are shortened by this factor; only their signs are asked for. A
// dot product of vectors of at most length 1, whose components have errors of p f and q f, has an error of sqrt(3)
// (p + q) f and three times f / 2. No true sum is larger than 1, so that a sum that stops at 1 has no larger error:
//   u.v         2 sqrt(3) + 1.5                5
//   b u.v       1 + 5 + 0.5                    6.5
//   b u.v - c   1 more                         7.5
//
// As an example the circle z = 0, so that u = z and b = 0, with E = x and F = y, and the caps x >= 0, y >= 0, -x >= 0
// and -y >= 0, each half of the sphere. The depth of the point at t in the first one is cos t:
//   arc            depth at its ends
//   -45 to 0        0.71   1             inside the first cap
//     0 to 45       1      0.71          inside it, too
//    45 to 90       0.71   0             not certainly: 0 is not above the margin. It is inside y >= 0 as a whole
// Each cap covers two of the eight arcs, and the four caps cover all: the circle is covered.
#pragma once

#include "sphere/crossing_pairs.hpp"

namespace hsp {
namespace {

constexpr float fraction_factor = 1.0F - 0x1p-10F;

// Vectors at most as long as fraction_factor.
struct LaneFractions {
  Fractions x, y, z;
};

// Stores caps as fractions, each of them twice.
inline void store_as_fractions(const LaneCaps<Floats> &caps, float *x, float *y, float *z, float *b) {
  Fractions::twice(caps.x, 1.0F).store(x);
  Fractions::twice(caps.y, 1.0F).store(y);
  Fractions::twice(caps.z, 1.0F).store(z);
  Fractions::twice(caps.b, fraction_factor).store(b);
}

// One such cap in all lanes.
struct FractionCap {
  Fractions x, y, z, b;

  static FractionCap all_of(const CapPointers<float> &caps, uint32_t k) {
    return {Fractions::all_of(caps.x + k), Fractions::all_of(caps.y + k), Fractions::all_of(caps.z + k),
            Fractions::all_of(caps.b + k)};
  }
  Fractions dot(const LaneFractions &a) const { return a.x * x + a.y * y + a.z * z; }
};

// As many circles as a register holds fractions.
struct FractionCircles {
  LaneFractions u;
  Fractions b;

  FractionCircles(const LaneCaps<Floats> &low, const LaneCaps<Floats> &high)
      : u{Fractions::of(low.x, high.x, fraction_factor), Fractions::of(low.y, high.y, fraction_factor),
          Fractions::of(low.z, high.z, fraction_factor)},
        b(Fractions::of(low.b, high.b, 1.0F)) {}
};

// The arcs of such circles that caps cover.
class CoveredArcs {
 public:
  using SomeCaps = LaneCaps<Floats>;

  // The circles in both words of floats; together these are as many as a register holds fractions.
  CoveredArcs(const SomeCaps &low, const SomeCaps &high) : CoveredArcs(low, high, Frames(low), Frames(high)) {}

  // Adds one more cap, which may cover arcs of the circles.
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

// How circles, as many as a register holds fractions, lie to the large caps. Let d = u_k.(b_j u_j) - b_k be the depth
// of the centre of circle j in cap k, and S = 1 - g^2. The circles cross iff q = S (1 - b_j^2) - d^2 > 0, and circle j
// lies inside cap k iff q < 0 and d > 0. Errors in units of f = 2^-15, by the first comment of this file: d 7.5, its
// square 15.5; g^2 10.5, S 11, 1 - b_j^2 1.1, their product 12.6; q 28.1, below the margin of 32. If d > 1, it stops at
// 1 and so does its square, which S (1 - b_j^2) does not exceed. If d < -0.99, -0.99 is taken for it: as b_k < 7/8,
// |b_j g| > 0.11 then, and S (1 - b_j^2) <= (1 - |b_j g|)^2 < 0.8, so that the circles still seem to be apart.
class AmongLargeCaps {
 public:
  AmongLargeCaps(const CapPointers<float> &large, uint32_t count, const LaneCaps<Floats> &low,
                 const LaneCaps<Floats> &high) {
    const FractionCircles circles(low, high);
    const Floats one = Floats::all(1.0F);
    const Fractions square = Fractions::of(minus_fused(low.b, low.b, one), minus_fused(high.b, high.b, one), 1.0F);
#pragma GCC unroll 2
    for (uint32_t t = 0; t < count; ++t) {
      const FractionCap cap = FractionCap::all_of(large, t);
      const Fractions g = cap.dot(circles.u);
      const Fractions depth = larger(g * circles.b - cap.b, Fractions::all(-0.99F));
      const Fractions S = Fractions::all(fraction_factor * fraction_factor) - g * g;
      const Fractions minus_q = depth * depth - S * square;
      inside_ = larger(inside_, smaller(depth, minus_q));
      least_ = smaller(least_, minus_q);
    }
    outside_ = inside_ - margin();
    crossing_ = least_ + margin();
  }
  // The circles that do not certainly lie inside one of the caps.
  LaneBits low_outside() const {
    return negative(outside_.signs_of_low());
  }
  LaneBits high_outside() const {
    return negative(outside_.signs_of_high());
  }
  // Negative for circles that certainly cross the circle of one of the caps.
  Floats low_crossing() const {
    return crossing_.signs_of_low();
  }
  Floats high_crossing() const {
    return crossing_.signs_of_high();
  }

 private:
  static Fractions margin() {
    return Fractions::all(0x1p-10F);
  }

  Fractions inside_ = Fractions::all(-1.0F), least_ = Fractions::all(1.0F - 0x1p-15F);
  Fractions outside_, crossing_;
};

// Whether one circle certainly crosses another one or lies inside a cap as a whole, by the formulas of AmongLargeCaps
// in floats. The caps are all caps of the ball; among them is the circle's own, for which nothing is certain. With e =
// 2^-24: if |d| < 1.2, its square has an error of 2.4 * 76 e, and the other product one of 95 e, together below 512 e;
// if |d| is larger, -q > 0.4. If -q > 512 e, |d| is above 512 e, too.
inline bool has_covered_point(const CapPointers<float> &caps, uint32_t count, uint32_t circle) {
  const LaneCaps<Floats> own = LaneCaps<Floats>::all_of(caps, circle);
  const Floats one = Floats::all(1.0F), margin = Floats::all(CapPairBounds<float>::crossing);
  const Floats square = minus_fused(own.b, own.b, one);
  Floats covered = Floats::all(-4.0F);
  for (uint32_t t = 0; t < count; t += Floats::lanes) {
    const LaneCaps<Floats> cap = LaneCaps<Floats>::load(caps, t);
    const Floats g = own.dot(cap);
    const Floats depth = fused_minus(g, own.b, cap.b);
    const Floats minus_q = minus_fused(minus_fused(g, g, one), square, depth * depth);
    covered = larger(covered, larger(smaller(depth, minus_q), -minus_q));
  }
  return greater(covered, margin) != 0;
}

}  // namespace
}  // namespace hsp
