// Two caps of one sphere in floating point, with proven error bounds: whether their circles cross, in which points, and
// how deep these points lie in other caps. The formulas are written once, as templates: for one double, for doubles in
// lanes and for floats in lanes; for a pair of caps, or for one cap with several. A template over a word type with
// internal linkage has internal linkage itself, as kernels need.
//
// On the unit sphere circle j is u_j.x = b_j. With g = u_j.u_k, S = 1 - g^2 = |u_j x u_k|^2 and
//   q = 1 - g^2 - b_j^2 - b_k^2 + 2 g b_j b_k     (D of lib/ground/exact up to a positive factor)
// the circles cross iff q > 0, in the points  alpha u_j + beta u_k +- gamma (u_j x u_k)  with
//   alpha = (b_j - g b_k)/S,  beta = (b_k - g b_j)/S,  gamma = sqrt(q)/S.
//
// Errors, first order, with |b| <= 1, q <= S <= 1. They hold whether the target rounds a product before it is added or
// fuses both. The units are e = 2^-53 in doubles (u 3.5, b 7 from caps.hpp) and e = 2^-24 in floats (u 6.5, b 29 from
// float_caps.hpp):
//                                                                                          doubles    floats
//   g         2 u + 3                                                                           10        16
//   q         1 - b_j^2: 2 b + 2; g^2: 2 g + 2; b_k^2: 2 b + 3; 2 g b_j b_k: 2 (g + 2 b) + 4;
//             last addition: 1                                                                 108       308
//   b_j - g b_k    2 b + g + 2                                                                  26        76
//   S         2 g + 2                                                                           22        34
// For the points put s = 1/S. |alpha|, |beta|, gamma <= sqrt(s) because alpha u_j + beta u_k has length at most 1.
// In doubles
//   alpha, beta       2 (26 s + 22 s sqrt(s) + sqrt(s)),  u: 7 sqrt(s)
//   gamma             56 sqrt(s)/sqrt(q) + 22 s + 2,  cross product: 12 sqrt(s),  additions: 8 sqrt(s) + 4
//   sum               at most 155 s sqrt(s) + 56 sqrt(s)/sqrt(q)
// and a test u_l.p - b_l of a point against a third cap adds 3.5 + 3 + 7 + 2. As s >= 1, all stays below
//   e s (256 s + 80/sqrt(q)).
// With q > 2^-32 the relative errors of S and q are below 2^-13, which the slack of a third absorbs. In floats
//   alpha, beta    2 (76 s + 34 s sqrt(s) + 4 sqrt(s)),  u: 13 sqrt(s)
//   gamma          154 s/sqrt(q) + 34 s sqrt(s) + 5 sqrt(s),  cross product: 16 sqrt(s),  additions: 2 sqrt(s) + 3
//   a test         6.5 + 29 + 7 more
// As s >= 1, all stays below e s (346 s + 154/sqrt(q)); used are 512 and 240. With q > 2^-12 the relative errors of q
// and S are below 0.076 and 0.009, which raise 154 by less than a tenth; what is left of the slack absorbs terms in e^2
// and the rounding of the bound.
//
// As an example the ball of radius 5 at 0 with the caps of balls of radius 5 at (6,0,0) and (0,6,0): u_j = x, u_k = y,
// b_j = b_k = 3/5. Then g = 0, S = 1 and q = 1 - 0.36 - 0.36 = 0.28 > 0: the circles cross. alpha = beta = 0.6 and
// gamma = sqrt(0.28) = 0.529, so that the points are (0.6, 0.6, +-0.529), 5 times of which is (3, 3, +-2.65).
#pragma once

#include <cstdint>

#include "core/vec3.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {

// For floats and doubles alike.
template <class Real>
struct CapPairBounds;
template <>
struct CapPairBounds<double> {
  static constexpr double roundoff = unit_roundoff;
  // Bounds of q: above the first it is certain that the circles cross, above the second it is certain in which points;
  // else the pair is left to the exact stage. The error of q, 108 e, is far smaller.
  static constexpr double crossing = 0x1p-32, points = crossing;
  static constexpr double centre = 32 * unit_roundoff;  // of g b_j - b_k, the depth of circle j's centre in cap k
  static constexpr double point_s = 256.0, point_root = 80.0;  // e s (point_s s + point_root / sqrt(q))
};
template <>
struct CapPairBounds<float> {
  static constexpr float roundoff = 0x1p-24F;
  static constexpr float crossing = 0x1p-15F;  // 512 e
  static constexpr float points = 0x1p-12F;
  static constexpr float centre = 0x1p-17F;  // 128 e
  static constexpr float point_s = 512.0F, point_root = 240.0F;
};

// A word of one double. Owner: void, or in a kernel a type with internal linkage.
template <class Owner>
struct OwnedDouble {
  using Real = double;
  double v;

  static OwnedDouble all(double x) { return {x}; }
  static OwnedDouble all_of(const double *p) { return {*p}; }

  friend OwnedDouble operator+(OwnedDouble a, OwnedDouble b) { return {a.v + b.v}; }
  friend OwnedDouble operator*(OwnedDouble a, OwnedDouble b) { return {a.v * b.v}; }
  friend OwnedDouble operator/(OwnedDouble a, OwnedDouble b) { return {a.v / b.v}; }
  friend OwnedDouble operator-(OwnedDouble a) { return {-a.v}; }
  friend OwnedDouble fused(OwnedDouble a, OwnedDouble b, OwnedDouble c) { return {a.v * b.v + c.v}; }
  friend OwnedDouble fused_minus(OwnedDouble a, OwnedDouble b, OwnedDouble c) { return {a.v * b.v - c.v}; }
  friend OwnedDouble minus_fused(OwnedDouble a, OwnedDouble b, OwnedDouble c) { return {c.v - a.v * b.v}; }
  friend OwnedDouble square_root(OwnedDouble a) { return {std::sqrt(a.v)}; }
  friend bool greater(OwnedDouble a, OwnedDouble b) { return a.v > b.v; }
};
using DoubleWord = OwnedDouble<void>;

// Caps in arrays.
template <class Real>
struct CapPointers {
  const Real *x, *y, *z, *b;
};

// Several caps, one in each lane, or one cap in all lanes.
template <class Lanes>
struct LaneCaps {
  Lanes x, y, z, b;

  static LaneCaps load(const CapPointers<typename Lanes::Real> &caps, uint32_t k) {
    return {Lanes::load(caps.x + k), Lanes::load(caps.y + k), Lanes::load(caps.z + k), Lanes::load(caps.b + k)};
  }
  static LaneCaps all_of(const CapPointers<typename Lanes::Real> &caps, uint32_t k) {
    return {Lanes::all_of(caps.x + k), Lanes::all_of(caps.y + k), Lanes::all_of(caps.z + k), Lanes::all_of(caps.b + k)};
  }
  Lanes dot(const LaneCaps &other) const { return fused(x, other.x, fused(y, other.y, z * other.z)); }
};

// Pairs of one cap j with several caps k.
template <class Lanes>
struct LanePairs {
  using Bounds = CapPairBounds<typename Lanes::Real>;
  Lanes g, q;
  Lanes bj, bk;

  LanePairs(const LaneCaps<Lanes> &cap, const LaneCaps<Lanes> &others)
      : g(cap.dot(others)),
        q(fused((cap.b + cap.b) * g, others.b,
                minus_fused(others.b, others.b, minus_fused(g, g, minus_fused(cap.b, cap.b, Lanes::all(1)))))),
        bj(cap.b),
        bk(others.b) {}

  auto certainly_cross() const { return greater(q, Lanes::all(Bounds::crossing)); }
  auto certainly_cross_in_points() const { return greater(q, Lanes::all(Bounds::points)); }  // points certain, too
  auto certainly_apart() const { return greater(Lanes::all(-Bounds::crossing), q); }
  auto may_cross() const { return not_greater(Lanes::all(-Bounds::crossing), q); }
  // For circles that do not cross: circle j lies inside cap k, or circle k inside cap j, or neither.
  auto certainly_inside() const { return greater(k_depth(), margin()); }
  auto certainly_outside() const { return greater(-margin(), k_depth()); }
  auto certainly_contains() const { return greater(j_depth(), margin()); }
  auto certainly_separate() const {
    const auto j_outside = certainly_outside(), k_outside = greater(-margin(), j_depth());
    return j_outside & k_outside;
  }

 private:
  static Lanes margin() { return Lanes::all(Bounds::centre); }
  // How deep the centres of circles j lie in caps k, and the other way round.
  Lanes k_depth() const { return fused_minus(g, bj, bk); }
  Lanes j_depth() const { return fused_minus(g, bk, bj); }
};

// For pairs with certainly_cross_in_points(): the chords between both points, as m + s gamma n, with s from -1 at p- to
// 1 at p+. `error` bounds the sum of the errors of f = u_l.m - b_l and g = gamma u_l.n for any cap l, hence those of
// f + g and f - g; two more additions are within its slack.
template <class Lanes>
struct LaneChords {
  Lanes mx, my, mz;
  Lanes nx, ny, nz, gamma;
  Lanes error;

  // Of caps u and v, with their g and q.
  LaneChords(const LaneCaps<Lanes> &u, const LaneCaps<Lanes> &v, Lanes g, Lanes q) {
    using Bounds = CapPairBounds<typename Lanes::Real>;
    const Lanes root = square_root(q);
    const Lanes S = minus_fused(g, g, Lanes::all(1));
    const Lanes shared = Lanes::all(1) / (S * root);
    const Lanes s = root * shared;
    const Lanes inverse_root = S * shared;
    const Lanes alpha = minus_fused(g, v.b, u.b) * s;
    const Lanes beta = minus_fused(g, u.b, v.b) * s;
    gamma = root * s;
    mx = fused(alpha, u.x, beta * v.x);
    my = fused(alpha, u.y, beta * v.y);
    mz = fused(alpha, u.z, beta * v.z);
    nx = fused_minus(u.y, v.z, u.z * v.y);
    ny = fused_minus(u.z, v.x, u.x * v.z);
    nz = fused_minus(u.x, v.y, u.y * v.x);
    error = s * Lanes::all(Bounds::roundoff) *
            fused(s, Lanes::all(Bounds::point_s), inverse_root * Lanes::all(Bounds::point_root));
  }
};

// Points p of the sphere, each with an error bound for its depth u.p - b in any cap.
template <class Lanes>
struct LanePoints {
  Lanes x, y, z, error;

  Lanes depth(const LaneCaps<Lanes> &cap) const {
    return fused(x, cap.x, fused(y, cap.y, fused_minus(z, cap.z, cap.b)));
  }
};

// Both points of pairs.
template <class Lanes>
struct LaneCrossings {
  LanePoints<Lanes> minus, plus;

  LaneCrossings(const LaneCaps<Lanes> &u, const LaneCaps<Lanes> &v, Lanes g, Lanes q)
      : LaneCrossings(LaneChords<Lanes>(u, v, g, q)) {}
  explicit LaneCrossings(const LaneChords<Lanes> &chord)
      : minus{minus_fused(chord.gamma, chord.nx, chord.mx), minus_fused(chord.gamma, chord.ny, chord.my),
              minus_fused(chord.gamma, chord.nz, chord.mz), chord.error},
        plus{fused(chord.gamma, chord.nx, chord.mx), fused(chord.gamma, chord.ny, chord.my),
             fused(chord.gamma, chord.nz, chord.mz), chord.error} {}

  // Makes the error bound infinite where the circles do not certainly cross in points.
  void doubt_uncertain(Lanes q) {
    using Bounds = CapPairBounds<typename Lanes::Real>;
    minus.error = plus.error = where_greater(q, Lanes::all(Bounds::points), plus.error, Lanes::all(__builtin_inff()));
  }
};

// One cap among those of a ball.
template <class Word, class Caps>
LaneCaps<Word> cap_in(const Caps &caps, uint32_t k) {
  return {{caps.ux[k]}, {caps.uy[k]}, {caps.uz[k]}, {caps.b[k]}};
}

// A pair of two caps in doubles, for code without lanes.
struct CapPair : LanePairs<DoubleWord> {
  template <class Caps>
  CapPair(const Caps &caps, uint32_t j, uint32_t k)
      : LanePairs<DoubleWord>(cap_in<DoubleWord>(caps, j), cap_in<DoubleWord>(caps, k)) {}
};

// The points p+ and p- of a pair that certainly crosses.
struct CrossingPoints {
  double x[2], y[2], z[2];  // index 0: p-, index 1: p+
  double error;             // of u_l.p - b_l for any cap l

  template <class Caps>
  CrossingPoints(const Caps &caps, uint32_t j, uint32_t k, const CapPair &pair)
      : CrossingPoints(
            LaneCrossings<DoubleWord>(cap_in<DoubleWord>(caps, j), cap_in<DoubleWord>(caps, k), pair.g, pair.q)) {}
  // The same from the difference of both planes. If the planes nearly agree, this is far more accurate: the factors s
  // and s sqrt(s) of the errors above, 1e8 and 1e12 for planes 1e-4 apart, become about sqrt(s), 1e4. The error bound
  // is found afterwards, from the distances of the computed points from both planes and the sphere.
  template <class Caps>
  CrossingPoints(const Caps &caps, uint32_t j, uint32_t k)
      : CrossingPoints(caps.axis(j), caps.axis(k) - caps.axis(j), caps.b[j], caps.b[k] - caps.b[j]) {}

 private:
  // Planes u.x = b and w.x = c, with n = u x w. As errors u and b have 3.5e and 7e, w and c 7e + |w| e <= 9e and
  // 14e + |c| e <= 16e, and n, as |w| <= 2, less than 3.5 * 2 + 9 + 6 = 22e. For a point p with | |p|^2 - 1 | < 2^-10:
  //   - Its distance from the true planes is at most R = |u.p - b| + 20e and Q = |w.p - c| + 40e; 20e and 40e hold the
  //     roundings of these values, too. The step from p to the line of the true planes has -R along the true u and,
  //     across u and the line, (Q + |u.w| R) / |n|. As |u.w| = |w|^2 / 2 <= 2, the step is no longer than D = R +
  //     (Q + 2 R) / N with N = |n| - 32e.
  //   - At the end p' of the step, | |p'|^2 - 1 | is at most E = | |p|^2 - 1 | + 8e + 4D, if D < 1. The distance of p'
  //     from the line's point nearest to the sphere's centre is at least T = |p.n| / |n| - 3D: the direction of n is
  //     off by less than 44e / N, its length by 22e, and D has 80e / N and more. If T > 0, p' is on the same side of
  //     that point as p, as p.n / |n| is off by less than 40e / N. If T^2 > E, the line meets the sphere on this side,
  //     at most E / T away from p'.
  // A test against a cap adds 3.5 + 7 + 4.
  CrossingPoints(const Vec3 &u, const Vec3 &w, double b, double c) {
    constexpr double e = unit_roundoff;
    const Vec3 n = cross(u, w);
    const double squared = dot(n, n), inverse = 1.0 / squared, length = std::sqrt(squared), N = length - 32.0 * e;
    const Vec3 m = inverse * combine(b, cross(w, n), c, cross(n, u));
    const double root = std::sqrt((1.0 - dot(m, m)) * inverse);
    error = 0.0;
    for (int point = 0; point < 2; ++point) {
      const Vec3 p = combine(1.0, m, point == 0 ? -root : root, n);
      x[point] = p.x;
      y[point] = p.y;
      z[point] = p.z;
      const double off_sphere = std::fabs(dot(p, p) - 1.0);
      const double R = std::fabs(dot(u, p) - b) + 20.0 * e, Q = std::fabs(dot(w, p) - c) + 40.0 * e;
      const double D = R + (Q + 2.0 * R) / N, E = off_sphere + 8.0 * e + 4.0 * D;
      const double T = std::fabs(dot(p, n)) / length - 3.0 * D;
      const bool certain = N > 0.0 && off_sphere < 0x1p-10 && D < 1.0 && T > 0.0 && T * T > E;
      const double bound = certain ? D + E / T + 16.0 * e : 8.0;  // nothing is so deep
      error = bound > error ? bound : error;
    }
  }
  explicit CrossingPoints(const LaneCrossings<DoubleWord> &p)
      : x{p.minus.x.v, p.plus.x.v}, y{p.minus.y.v, p.plus.y.v}, z{p.minus.z.v, p.plus.z.v}, error(p.plus.error.v) {}
};

// The chord between the points of a pair that certainly crosses, as m + s w with s from -1 to 1.
struct UnitChord {
  Vec3 m, w;
  double error;

  template <class Caps>
  UnitChord(const Caps &caps, uint32_t j, uint32_t k, const CapPair &pair)
      : UnitChord(LaneChords<DoubleWord>(cap_in<DoubleWord>(caps, j), cap_in<DoubleWord>(caps, k), pair.g, pair.q)) {}

 private:
  explicit UnitChord(const LaneChords<DoubleWord> &chord)
      : m{chord.mx.v, chord.my.v, chord.mz.v},
        w{(chord.gamma * chord.nx).v, (chord.gamma * chord.ny).v, (chord.gamma * chord.nz).v},
        error(chord.error.v) {}
};

}  // namespace hsp
