// Two caps of one sphere in doubles, with proven error bounds: whether their circles cross, and where.
//
// On the unit sphere circle j is u_j.x = b_j. With g = u_j.u_k, S = 1 - g^2 = |u_j x u_k|^2 and
//   q = 1 - g^2 - b_j^2 - b_k^2 + 2 g b_j b_k     (D of lib/ground/exact up to a positive factor)
// the circles cross iff q > 0, in the points  alpha u_j + beta u_k +- gamma (u_j x u_k)  with
//   alpha = (b_j - g b_k)/S,  beta = (b_k - g b_j)/S,  gamma = sqrt(q)/S.
//
// Errors, in units of e = 2^-53, first order (u 3.5, b 7 from caps.hpp; |b| <= 1, q <= S <= 1):
//   g      2 * 3.5 + 3                                                                         10
//   q      1 - g^2: 22; b_j^2 + b_k^2: 2 * 15 + 2; 2 g b_j b_k: 2 * 24 + 4; additions: 5            111
//   b_j - g b_k   7 + 18 + 2                                                                   27
// For the points put s = 1/S. |alpha|, |beta|, gamma <= sqrt(s) because alpha u_j + beta u_k has length at most 1.
//   alpha, beta       2 (27 s + 22 s sqrt(s) + sqrt(s)),  u: 7 sqrt(s)
//   gamma             56 sqrt(s)/sqrt(q) + 22 s + 2,  cross product: 12 sqrt(s),  additions: 8 sqrt(s) + 4
//   sum               at most 155 s sqrt(s) + 56 sqrt(s)/sqrt(q)
// and a test u_l.p - b_l of a point against a third cap adds 3.5 + 3 + 7 + 2. As s >= 1, all stays below
//   e s (256 s + 80/sqrt(q)).
// With q > 2^-32 the relative errors of S and q are below 2^-13, which the slack of a third absorbs.
#pragma once

#include "exact/circle_crossing.hpp"
#include "sphere/cap_pair_bounds.hpp"
#include "sphere/caps.hpp"

namespace hsp {

struct CapPair {
  double g, bj, bk, q;

  CapPair(const Caps &caps, uint32_t j, uint32_t k)
      : g(caps.ux[j] * caps.ux[k] + caps.uy[j] * caps.uy[k] + caps.uz[j] * caps.uz[k]), bj(caps.b[j]), bk(caps.b[k]) {
    q = (1.0 - g * g) - (bj * bj + bk * bk) + 2.0 * (g * bj * bk);
  }
  // Comparisons are false for NaN (radius 0), so that such pairs are certain of nothing.
  bool certainly_cross() const { return q > certain_discriminant; }
  bool certainly_apart() const { return q < -certain_discriminant; }
  // For circles that do not cross: circle j lies inside cap k, or circle k inside cap j, or neither.
  bool certainly_inside() const { return g * bj - bk > certain_centre; }
  bool certainly_outside() const { return g * bj - bk < -certain_centre; }
  bool certainly_contains() const { return g * bk - bj > certain_centre; }
  bool certainly_separate() const { return g * bj - bk < -certain_centre && g * bk - bj < -certain_centre; }
};

// The points p+ and p- of a pair that certainly crosses.
struct CrossingPoints {
  double x[2], y[2], z[2];  // index 0: p-, index 1: p+
  double error;             // of u_l.p - b_l for any cap l

  CrossingPoints(const Caps &caps, uint32_t j, uint32_t k, const CapPair &pair) {
    const UnitCircleCrossing crossing(caps.axis(j), pair.bj, caps.axis(k), pair.bk, pair.g);
    const double root = std::sqrt(pair.q);
    const double shared = 1.0 / (crossing.nn * root);
    const double s = root * shared;
    const double inverse_root = crossing.nn * shared;
    const Vec3 middle = crossing.scaled_middle(s);
    const Vec3 half_chord = crossing.scaled_normal(root * s);
    const Vec3 p[2] = {middle - half_chord, middle + half_chord};
    for (int sign = 0; sign < 2; ++sign) {
      x[sign] = p[sign].x;
      y[sign] = p[sign].y;
      z[sign] = p[sign].z;
    }
    error = unit_roundoff * s * (256.0 * s + 80.0 * inverse_root);
  }
};

// Their chord as m + s w, with s from -1 at p- to 1 at p+. The bound adds up the errors of both parts, so it bounds
// f = u_l.m - b_l and g = u_l.w together, and f + g and f - g; two more additions are within its slack.
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
