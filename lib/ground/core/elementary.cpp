#include "core/elementary.hpp"

#include <cstdint>

namespace hsp {
namespace {

// atan(t) - t for |t| <= 1/16 + 2^-8 by the Taylor series; the first term left out, t^17/17, is below 2^-69 t.
double correction_near_zero(double t) {
  const double z = t * t;
  return t * z *
         (-1.0 / 3 +
          z * (1.0 / 5 + z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13 - z * (1.0 / 15)))))));
}

// The same for |t| <= 3/16 + 2^-8; the first term left out, t^27/27, is below 2^-66 t.
double correction_near_origin(double t) {
  const double z = t * t;
  const double tail = 1.0 / 17 + z * (-1.0 / 19 + z * (1.0 / 21 + z * (-1.0 / 23 + z * (1.0 / 25))));
  return t * z *
         (-1.0 / 3 +
          z * (1.0 / 5 +
               z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13 + z * (-1.0 / 15 + z * tail)))))));
}

}  // namespace

// With u = 2^-53 and 0 <= y <= x: below 3/16 the result is t + correction(t), t = y/x; errors u t from the division, 4u
// times the correction (under t/80) and u from the last addition. Above, let c = k/8 be the multiple of 1/8 nearest to
// y/x and t = (y - c x)/(x + c y), so that atan(y/x) = atan(c) + atan(t) and |t| <= 1/16. x is split into a high part
// of 48 bits and a low part, so that both products by c are exact and y - c x is rounded once, relative to itself; with
// the denominator (2u) and the division (u), |dt| <= 4u |t| <= u/4, which is 1.35u of the result at its smallest, 3/16;
// the last addition adds u. An ulp is between u and 2u of the result, at most 1.35u where |dt| weighs most; the
// reflections at pi/2 and pi keep their errors in the low part and enlarge the result. Hence less than 2 ulp.
double arc_tangent(double y, double x) {
  const double ay = y < 0.0 ? -y : y;
  const double ax = x < 0.0 ? -x : x;
  const bool steep = ay > ax;
  double small = steep ? ax : ay;
  double large = steep ? ay : ax;
  if (large == 0.0) return 0.0;

  const double ratio = small / large;
  const int k = static_cast<int>(ratio * 8.0 + 0.5);
  double high = ratio;
  double low = 0.0;
  if (k <= 1) {
    low = correction_near_origin(ratio);
  } else {
    if (large > 0x1p900) {  // prevents overflow in the split below; only the ratio matters
      small *= 0x1p-64;
      large *= 0x1p-64;
    }
    const double c = eighth_tangents[k].tangent;
    const double spread = large * 33.0;  // Dekker's split, factor 2^5 + 1
    const double large_high = spread - (spread - large);
    const double t = ((small - c * large_high) - c * (large - large_high)) / (large + c * small);
    high = eighth_tangents[k].high;
    low = eighth_tangents[k].low + (t + correction_near_zero(t));
  }
  if (steep) {
    // pi/2 - (high + low), the two high parts first: their difference is exact or rounded far below the result's ulp.
    const double difference = pi / 2 - high;
    const double error = (pi / 2 - difference) - high;
    low = pi_low / 2 + error - low;
    high = difference;
  }
  if (x < 0.0) {
    const double difference = pi - high;
    const double error = (pi - difference) - high;
    low = pi_low + error - low;
    high = difference;
  }
  const double angle = high + low;
  return y < 0.0 ? -angle : angle;
}

// The angle is brought to r in [-pi/4, pi/4] by multiples k of pi/2 = first + second, first having 33 bits: k < 2^20
// makes k first exact, and the difference from the angle is exact too (Sterbenz, or both have few bits); k second and
// the last difference put an error of 1.5 units of 2^-53 into r at most, for k second < 2^-14. The Taylor series lack
// r^19/19! < 2^-63 and r^18/18! < 2^-58; evaluating them costs less than 1.1 units, as all that is added to r and to 1
// is below a third of it.
SinCos sin_cos(double angle) {
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  constexpr double first = 0x1.921fb544p+0;
  constexpr double second = 0x1.0b4611a626331p-34;
  const double quarters = angle * two_over_pi;
  const int64_t k = static_cast<int64_t>(quarters < 0.0 ? quarters - 0.5 : quarters + 0.5);
  const double r = (angle - static_cast<double>(k) * first) - static_cast<double>(k) * second;
  const double z = r * r;
  const double sine =
      r + r * z *
              (-1.0 / 6 +
               z * (1.0 / 120 +
                    z * (-1.0 / 5040 + z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                                                z * (1.0 / 6227020800 + z * (-1.0 / 1307674368000 +
                                                                                             z / 355687428096000)))))));
  const double cosine =
      1.0 -
      z * (1.0 / 2 -
           z * (1.0 / 24 -
                z * (1.0 / 720 -
                     z * (1.0 / 40320 - z * (1.0 / 3628800 -
                                             z * (1.0 / 479001600 - z * (1.0 / 87178291200 - z / 20922789888000)))))));
  switch (k & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace hsp
