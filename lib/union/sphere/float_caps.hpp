// The caps of one ball as floats, for kernels: a point x of the unit sphere lies in the cap iff u.x >= b, as in
// caps.hpp.
//
// Errors in units of e = 2^-24, first order. The differences of centres v, the difference p and the sum s of the radii
// are integers rounded once, the ball's radius r as well:
//   |v|^2     relative 2 by v, 3 by the fused sum                                                        5
//   |v|, 1/|v|   relative 2.5 + 1, + 1                                                             3.5, 4.5
//   u         relative 1 by v, 4.5, 1, in each component                                                 6.5
//   h = |v|^2 - p s    5 |v|^2 + 3 |p s| + |h|, 2 |p s| where it is fused
//   b = h / (2 r |v|)  with t = |v| / (2 r) <= 2 and |b| <= 1, so that |p s| / (2 r |v|) <= t + 1:
//             5 t + 3 (t + 1) + 1, and 4.5 + 1 by 1/|v|, 2 by 1/(2 r), 1                     8 t + 12.5 <= 28.5
// used: u 6.5, b 29. tests/proofs/float_caps_bounds.gappa reads this line. Whether two balls meet in a proper circle is
// decided with a relative margin of 32; |v|^2 has a relative error of 5, s^2 and p^2 of 4.
#pragma once

#include "lanes/target.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

// Arrays of caps; the pointers may point to any cap.
struct FloatCaps {
  static constexpr uint32_t spare = 8;  // entries behind the last cap that may be written and read
  float *x = nullptr, *y = nullptr, *z = nullptr, *b = nullptr;

  // Writes caps in which nothing lies behind the first `count` caps.
  void pad(uint32_t count) const {
    for (uint32_t k = count; k < count + spare; ++k) {
      x[k] = y[k] = z[k] = 0.0F;
      b[k] = 4.0F;
    }
  }
};

// Makes the caps of ball i by the `count` balls in `near`, and behind them, up to a multiple of eight, caps in which
// nothing lies. Returns false if one of the balls is not certain to meet ball i in a proper circle, or is more than
// four radii of ball i away. Writes spare_ids ids behind the last ball in `near`.
HSP_KERNEL(bool, make_float_caps,
           (const BallArrays &balls, uint32_t i, uint32_t *near, uint32_t count, const FloatCaps &caps),
           (balls, i, near, count, caps))

}  // namespace hsp
