// The angles of several directions in the plane at once, computed without branches and without tables: every arc needs
// one, and the octants of arcs cannot be predicted.
#pragma once

#include "lanes/wide.hpp"

namespace hsp {
namespace {

// An angle as a multiple of pi/4 and the rest. The multiple is that of pi/4 as a double, exactly: pi has so many zeros
// at the end that those up to 8 are doubles.
template <class L>
struct AngleParts {
  typename L::Real multiple, rest;

  typename L::Real sum() const { return multiple + (rest + multiple * (pi_low / pi)); }
};

// The angle of (x, |y|), counter-clockwise from (1, 0), in [0, pi]; (x, y) must not be (0, 0), and neither component
// may be near the ends of the range.
//
// In an octant the angle is atan(t), t = small/large, where that is at most 53/128, a little below tan(pi/8), and else
// pi/4 + atan(t), t = (small - large)/(large + small), so that |t| < 0.4144. With z = t^2, atan(t) is t + t z P(z), P
// of degree 10: the polynomial of least largest error of t z P relative to t for z <= 0.1717, by Remez's algorithm, an
// error below 2^-59. In units of e = 2^-53: difference, sum and quotient move t by |t| each; the difference is exact
// above 1/2, and the first two are not there without the pi/4. The correction, below 0.054 |t|, has a relative error of
// at most 7, and the sum with t adds 1, each relative to |t|. So an angle below pi/8 has an error of at most 2.4 e of
// itself; the rest of another one has 1.25 + 0.55 from these, and 0.25 with what pi lacks. The sum of the parts adds
// half a unit in the last place: 0.25 e next to pi/8, 2 e up to pi, 4 e up to 2 pi. Together at most 6.1 e, 4.1 e up to
// pi, and 6 e of the angle.
// L: Wide or WidePairs.
template <class L>
#if !defined(__OPTIMIZE_SIZE__)
[[gnu::always_inline]]
#endif
inline AngleParts<L>
half_turn_angle(const typename L::Real &x, const typename L::Real &y) {
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  const Real ax = L::absolute(x);
  const Real ay = L::absolute(y);
  const Mask steep = ay > ax;
  const Real large = L::larger(ax, ay);
  const Real small = L::smaller(ax, ay);
  const Mask wide = small > large * 0.4140625;
  const Real t = (small - L::kept(wide, large)) / (large + L::kept(wide, small));
  const Real z = t * t;
  const Real w = z * z;
  const Real even = -0x1.555555555553dp-2 +
                    w * (-0x1.24924922ae999p-3 +
                         w * (-0x1.745cf8ec6274ep-4 +
                              w * (-0x1.10ebc3d4b2d84p-4 + w * (-0x1.9cd53601ca0eap-5 + w * -0x1.25750440fe278p-6))));
  const Real odd =
      0x1.9999999995889p-3 +
      w * (0x1.c71c70e69aa0cp-4 + w * (0x1.3b111a30380aap-4 + w * (0x1.df0fe65c3b514p-5 + w * 0x1.37db3ad28d7b9p-5)));
  const Mask left = x < 0.0;
  const Real quarter = L::negate_if(steep, L::kept(wide, L::all(pi / 4))) + L::kept(steep, L::all(pi / 2));
  const Real half = L::negate_if(left, quarter) + L::kept(left, L::all(pi));
  return {half, L::negate_if(steep ^ left, t + t * z * (even + z * odd))};
}

// The angle of (x, y) in [-pi, pi], with the sign of y, also where y is a zero.
template <uint32_t n>
typename Wide<double, n>::Real signed_angle(const typename Wide<double, n>::Real &x,
                                            const typename Wide<double, n>::Real &y) {
  using L = Wide<double, n>;
  return L::negate_if(L::bits(y), half_turn_angle<L>(x, y).sum());
}

// The angle of (x, y) in [0, 2 pi].
template <uint32_t n>
#if !defined(__OPTIMIZE_SIZE__)
[[gnu::always_inline]]
#endif
inline typename Wide<double, n>::Real
turn_angle(const typename Wide<double, n>::Real &x, const typename Wide<double, n>::Real &y) {
  using L = Wide<double, n>;
  const typename L::Mask below = y < 0.0;
  AngleParts<L> angle = half_turn_angle<L>(x, y);
  angle.multiple = L::negate_if(below, angle.multiple) + L::kept(below, L::all(2 * pi));
  angle.rest = L::negate_if(below, angle.rest);
  return angle.sum();
}

}  // namespace
}  // namespace hsp
