// The angle of a direction in the plane by arithmetic without branches: a boundary asks for one per arc, and the
// octants of arcs cannot be predicted.
#pragma once

#include <cstdint>

#include "core/floating_point.hpp"

namespace hsp {

// The angle of (x, y), counter-clockwise from (1, 0), in [0, 2 pi]; (x, y) must not be (0, 0), and neither component
// may be near the ends of the range. Error at most 4 units of 2^-53 relative to the angle in the first half-turn, to 2
// pi in the second.
//
// Within an octant with t0 = small/large let c = k/8 be the multiple of 1/8 nearest to t0 and
// t = (small - c large)/(large + c small), so that atan(t0) = atan(c) + atan(t), |t| <= 1/16. Errors in units of e:
// c large is rounded for k = 3, 5, 6, 7, which moves t by c at most, 1.2 of the result; the difference, the sum of the
// denominator (2) and the quotient move it by 4 |t| <= 1/4 (all of the result for k = 0, where the denominator is
// exact and they are 2); atan(c) by 1/2, the last sum by 1, the reflection by 1.
inline double turn_angle(double x, double y) {
  constexpr double arc_tangents[9] = {0x0.0p+0,
                                      0x1.fd5ba9aac2f6ep-4,
                                      0x1.f5b75f92c80ddp-3,
                                      0x1.6f61941e4def1p-2,
                                      0x1.dac670561bb4fp-2,
                                      0x1.1e00babdefeb4p-1,
                                      0x1.4978fa3269ee1p-1,
                                      0x1.700a7c5784634p-1,
                                      0x1.921fb54442d18p-1};  // of k/8
  // By octant: bit 0 if x < 0, bit 1 if y < 0, bit 2 if |y| > |x|.
  constexpr double base[8] = {0.0, pi, 2 * pi, pi, pi / 2, pi / 2, 3 * (pi / 2), 3 * (pi / 2)};
  constexpr double sign[8] = {1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0};
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  const double large = ay > ax ? ay : ax;
  const double small = ay > ax ? ax : ay;
  const int32_t k = static_cast<int32_t>(small / large * 8.0 + 0.5);
  const double c = 0.125 * k;
  const double t = (small - c * large) / (large + c * small);
  // The Taylor series; its first term left out, t^15/15, is below 2^-59 t.
  const double z = t * t;
  const double correction =
      t * z * (-1.0 / 3 + z * (1.0 / 5 + z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13))))));
  const double angle = arc_tangents[k] + (t + correction);
  const uint32_t octant =
      static_cast<uint32_t>(x < 0.0) | static_cast<uint32_t>(y < 0.0) << 1 | static_cast<uint32_t>(ay > ax) << 2;
  return base[octant] + sign[octant] * angle;
}

}  // namespace hsp
