// The chord of two caps that certainly cross, on the unit sphere as m + s w, with s from -1 at p- to 1 at p+. The
// error bound of a test u_l.p - b_l of p+ and p- (cap_pair.hpp) adds up the errors of both parts, so that it bounds
// f = u_l.m - b_l and g = u_l.w together, and f + g and f - g; two more additions are within its slack.
#pragma once

#include "sphere/cap_pair.hpp"

namespace hsp {

struct UnitChord {
  Vec3 m, w;
  double error;

  UnitChord(const Caps &caps, uint32_t j, uint32_t k, const CapPair &pair) {
    const UnitCircleCrossing crossing(caps.axis(j), pair.bj, caps.axis(k), pair.bk, pair.g);
    const double root = std::sqrt(pair.q);
    const double s = 1.0 / crossing.nn;
    m = crossing.scaled_middle(s);
    w = crossing.scaled_normal(root * s);
    error = unit_roundoff * s * (256.0 * s + 80.0 / root);
  }
};

}  // namespace hsp
