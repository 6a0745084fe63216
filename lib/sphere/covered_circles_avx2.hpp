// Which circles of caps are certainly covered by other caps, in floats: for files *_avx2.cpp alone. Nothing on such a
// circle is free, so that none of its pairs has to be looked at. Most circles of a ball with many caps are such.
//
// A circle is cut into eight arcs of 45 degrees, and is covered if each arc lies inside one of the caps. With u, b the
// cap of the circle, v, c another one, E and F unit vectors across u and each other, and r = sqrt(1 - b^2), the depth
// of the circle's point at angle t in the other cap is d(t) = A + X cos t + Y sin t with A = b u.v - c, X = r E.v and
// Y = r F.v. It is known to within 1024 e (e = 2^-24, first order):
//   A        73, as in cap_pair_bounds.hpp
//   E, F     u has a length within 11 of 1 and is 11 from the true one; they turn with u no more than three times as
//            far; 1 / (1 + |z|) is known to 3:                                                                   36
//   r        for 1 - b^2 > 2^-8, so that r > 2^-4: 57 / (2 r) + 1 < 457
//   X, Y     457 + 36 + 11 by v + 4 by the sums < 512; |X cos t + Y sin t| at eighths of a turn: 725 + 4
//
// If d exceeds a margin at both ends of an arc and its least value is at one of them, the arc lies inside the cap. The
// least value is between the ends only if the direction t where X cos t + Y sin t = -B, B its largest value, is; then
// the nearer end is no more than 22.5 degrees from it, and there d <= A - 0.9238 B. To exclude that, A is lowered to
// 0.92 max(|X|, |Y|) <= 0.92 B where it is larger, which makes no d larger: then d <= -0.0038 B + 1024 e, which is
// below the margin of 2^-12 = 4096 e. Only signs are kept, as they are put together by operations on bits.
#pragma once

#include "sphere/crossing_pairs_avx2.hpp"

namespace hsp {
namespace {

class CoveredArcs {
 public:
  using Caps8 = LaneCaps<Floats>;

  // Eight circles.
  explicit CoveredArcs(const Caps8 &circles) : circles_(circles) {
    // Across u = (x, y, z), with s the sign of z, a = -1 / (s + z) and p = x y a (Duff et al., Building an Orthonormal
    // Basis, Revisited, JCGT 6 (1), 2017): E = (1 + s x^2 a, s p, -s x) and F = (p, s + y^2 a, -y).
    const Floats one = Floats::all(1.0F);
    const Floats s = with_sign_of(one, circles.z);
    const Floats a = -(one / (s + circles.z));
    const Floats p = circles.x * circles.y * a;
    const Floats squared = minus_fused(circles.b, circles.b, one);
    const Floats r = square_root(squared);
    wide_ = greater(squared, Floats::all(0x1p-8F));
    ex_ = r * fused(s * circles.x, circles.x * a, one);
    ey_ = r * s * p;
    ez_ = -(r * s * circles.x);
    fx_ = r * p;
    fy_ = r * fused(circles.y, circles.y * a, s);
    fz_ = -(r * circles.y);
    for (Floats &open : open_) open = Floats::all(-1.0F);
  }

  // One more cap that may cover arcs of them.
  void cover(const Caps8 &cap) {
    const Floats x = fused(ex_, cap.x, fused(ey_, cap.y, ez_ * cap.z));
    const Floats y = fused(fx_, cap.x, fused(fy_, cap.y, fz_ * cap.z));
    const Floats most = larger(magnitude(x), magnitude(y)) * Floats::all(0.92F);
    const Floats a = smaller(fused_minus(circles_.dot(cap), circles_.b, cap.b), most) - Floats::all(0x1p-12F);
    const Floats sum = x + y, rest = y - x, eighth = Floats::all(0.70710678F);
    const Floats end[8] = {a + x, fused(eighth, sum, a),       a + y, fused(eighth, rest, a),
                           a - x, minus_fused(eighth, sum, a), a - y, minus_fused(eighth, rest, a)};
    for (int k = 0; k < 8; ++k) open_[k] = both_negative(open_[k], either_negative(end[k], end[(k + 1) % 8]));
  }

  // The circles that are covered as a whole.
  LaneBits covered() const {
    Floats any = open_[0];
    for (int k = 1; k < 8; ++k) any = either_negative(any, open_[k]);
    return wide_ & ~negative(any);
  }

 private:
  Caps8 circles_;
  LaneBits wide_;
  Floats ex_, ey_, ez_, fx_, fy_, fz_;  // r E and r F
  Floats open_[8];                      // negative for arcs that no cap has covered so far
};

}  // namespace
}  // namespace hsp
