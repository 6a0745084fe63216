#include "core/elementary.hpp"

#include <cstdint>

#include "lanes/angle.hpp"

namespace hsp {

double arc_tangent(double y, double x) {
  const double size = std::fabs(x) > std::fabs(y) ? std::fabs(x) : std::fabs(y);
  if (size == 0.0) return 0.0;
  y += 0.0;                                 // -0 becomes 0
  if (size > 0x1p900 || size < 0x1p-900) {  // sums would overflow, and halves of subnormals would be rounded
    const double scale = size > 1.0 ? 0x1p-64 : 0x1p64;
    y *= scale;
    x *= scale;
  }
  return signed_angle<OneDouble>(x, y);
}

// The angle is reduced to r in [-pi/4, pi/4] by a multiple k of pi/2 = first + second, where first has 33 bits. As k <
// 2^20, k first is exact, and its difference from the angle is exact, too (Sterbenz, or both have few bits). As k
// second < 2^-14, k second and the last difference put an error of at most 1.5 units of 2^-53 into r. The Taylor series
// leave out r^19/19! < 2^-63 and r^18/18! < 2^-58; evaluating them costs less than 0.8 and 1.2 units, as tests/proofs
// shows.
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
