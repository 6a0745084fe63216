// The angles of two directions in the plane, computed without branches: every arc needs one, and the octants of arcs
// cannot be predicted.
#pragma once

#include "core/elementary.hpp"
#include "core/simd.hpp"

namespace hsp {

// The angle of (x, y), counter-clockwise from (1, 0), in [0, 2 pi]; (x, y) must not be (0, 0), and neither component
// may be near the ends of the range.
//
// In an octant let c = k/8 be the multiple of 1/8 nearest to small/large, or a neighbour of it, and
// t = (small - c large)/(large + c small), so that the angle is atan(c) + atan(t), |t| <= 1/16. In units of e = 2^-53:
// c large is rounded for k = 3, 5, 6, 7 and moves t by 1/2 then; the difference, the denominator and the quotient move
// it by 4 |t|; the Taylor series lacks t^15/15 < 2^-59 t; atan(c) and the last sum add twice the angle. So the angle
// has an error of at most 7 e of itself, and of 2.4 e. The reflections at pi/2, pi and 2 pi add their own error and
// that of the constant: 2.2, 4.3 and 8.5 e. Together at most 18 e, and 8 e of the angle.
inline Lanes turn_angle(const Lanes &x, const Lanes &y) {
  const Lanes ax = absolute(x);
  const Lanes ay = absolute(y);
  const LaneMask steep = ay > ax;
  const Lanes large = select(steep, ay, ax);
  const Lanes small = select(steep, ax, ay);
  const Lanes rounded = small / large * 8.0 + 0.5;
  const EighthTangent &first = eighth_tangents[static_cast<int32_t>(rounded[0])];
  const EighthTangent &second = eighth_tangents[static_cast<int32_t>(rounded[1])];
  const Lanes c{first.tangent, second.tangent};
  const Lanes t = (small - c * large) / (large + c * small);
  const Lanes z = t * t;
  const Lanes correction =
      t * z * (-1.0 / 3 + z * (1.0 / 5 + z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13))))));
  const Lanes octant = Lanes{first.high, second.high} + (t + correction);
  const LaneMask left = x < 0.0;
  const LaneMask below = y < 0.0;
  const Lanes quarter = negate_if(steep, octant) + mask_and(steep, all_lanes(pi / 2));
  const Lanes half = negate_if(left, quarter) + mask_and(left, all_lanes(pi));
  return negate_if(below, half) + mask_and(below, all_lanes(2 * pi));
}

}  // namespace hsp
