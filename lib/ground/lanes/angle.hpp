// The library's arc tangent, without tables, and in lanes without branches, as the octants of arcs cannot be predicted.
// A word holds several directions, or one.
#pragma once

#include "lanes/wide.hpp"

namespace hsp {
namespace {

// A word of one double, for core/elementary.hpp: compilers make better code for it than for a vector of one number.
struct OneDouble {
  using Real = double;
  using Mask = bool;

  static double all(double x) { return x; }
  static double kept(bool mask, double a) { return mask ? a : 0.0; }
  static double negate_if(bool mask, double a) { return mask ? -a : a; }
  static double with_sign(double a, double b) { return __builtin_copysign(a, b); }  // no call at -O0
  static double absolute(double a) { return std::fabs(a); }
  static double larger(double a, double b) { return a > b ? a : b; }
  static double smaller(double a, double b) { return a < b ? a : b; }
};

// atan(1/2) is the sum of both numbers and of what AngleParts::sum() adds in proportion to the first. The first is a
// multiple of 2^-50.
constexpr double half_tangent = 0x1.dac670561bb5p-2;
constexpr double half_tangent_low = -0x1.d55788e1b59b2p-55;

// An angle as two parts. `corner` is the multiple of pi/2 next to its octant, perhaps with atan(1/2) added or
// subtracted. It is exact: pi has so many zero bits at its end that its quarters are multiples of 2^-50, too.
template <class L>
struct AngleParts {
  typename L::Real corner, rest;

  typename L::Real sum() const { return corner + (rest + corner * (pi_low / pi)); }
};

// The angle of (x, |y|), counter-clockwise from (1, 0), in [0, pi]; (x, y) must not be (0, 0), and neither component
// may be near the ends of the range.
//
// In an octant let r = small/large. If r is at most 21/64, the angle is atan(t) with t = r. Else it is atan(1/2) +
// atan(t) with t = (small - large/2)/(large + small/2), in [-0.148, 1/3]. With z = t^2, atan(t) is t + t z P(z), where
// P has degree 8: the minimax polynomial for the error of t z P relative to t for z <= 1/9, by Remez's algorithm, an
// error below 0.15 e where e = 2^-53.
//
// The quotient has an error of e |t|. With atan(1/2), the rounded sum large + small/2 moves t as much, but the
// difference is exact (Sterbenz) and so are the halves. The correction is below 0.037 |t|. It has
// a relative error of at most 7 e besides that of P (tests/proofs/angle_bounds.gappa reads this line), and its sum with
// t is rounded by half a unit in the last place. So
// - if t = r, an angle below pi/4 has an error of at most 2.4 e of itself, less than 2 units in the last place: 0.4
//   from the correction and P, and 1 from both roundings. If t is in a binade with larger units than the angle, the
//   roundings are 1.5, but then t is below 0.256 and the errors of the correction and P are below 0.3;
// - for other angles `rest` has an error of at most 1.12 e, or 0.5 e if t < 0; pi_low adds 0.25 e, or at most half of
//   that for angles below 1/2; the sum of the parts adds half a unit in the last place. These angles are above 0.31. A
//   unit is e/2 up to 1/2, where t < 0.04; e up to 1; 2 e up to 2; 4 e up to 4. The error is below 2 units up to pi.
// Together at most 5.4 e, 3.4 e up to pi, and 2.7 e of the angle.
// L: Wide, WidePairs or OneDouble.
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
  const Mask wide = small > large * 0.328125;
  const Real c = L::kept(wide, L::all(0.5));
  const Real t = (small - c * large) / (large + c * small);
  const Real z = t * t;
  const Real w = z * z;
  const Real even = -0x1.5555555555403p-2 +
                    w * (-0x1.24924906fda00p-3 +
                         w * (-0x1.745b2388a784ep-4 + w * (-0x1.0eebfec701ae0p-4 + w * -0x1.0af7a2951d3eep-5)));
  const Real odd =
      0x1.999999995d5aap-3 + w * (0x1.c71c6382d77a7p-4 + w * (0x1.3aea2da99710ep-4 + w * 0x1.bf06e5e0c6b93p-5));
  const Real correction = t * z * (even + z * odd) + L::kept(wide, L::all(half_tangent_low));
  const Mask left = x < 0.0;
  const Real quarter = L::negate_if(steep, L::kept(wide, L::all(half_tangent))) + L::kept(steep, L::all(pi / 2));
  const Real half = L::negate_if(left, quarter) + L::kept(left, L::all(pi));
  return {half, L::negate_if(steep ^ left, t + correction)};
}

// The angle of (x, y) in [-pi, pi], with the sign of y, also if y is a zero.
template <class L>
typename L::Real signed_angle(const typename L::Real &x, const typename L::Real &y) {
  return L::with_sign(half_turn_angle<L>(x, y).sum(), y);
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
  angle.corner = L::negate_if(below, angle.corner) + L::kept(below, L::all(2 * pi));
  angle.rest = L::negate_if(below, angle.rest);
  return angle.sum();
}

}  // namespace
}  // namespace hsp
