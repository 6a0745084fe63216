// The filter stage of the predicates: the polynomials of plane.hpp in doubles, with static error bounds for one sphere.
// An answer is +1 or -1 if it is certain, and 0 if the exact stage has to decide.
//
// Errors, with L^2 = max(W, |v|^2) over the planes in use and e = 2^-53. n, h and W are exact integers that are
// converted with one rounding each.
//   q: 6e L^3      D: W N relative 7e, q.q 36e L^6, last subtraction 5e L^6     |D error| <= 48e L^6, used 64
//   H: 18.5e L^4   A: 18.5 + 3 + 9                                              |A error| <= 30.5e L^6, used 64
//   B: 4e L^3, used 8         F: W B B 11, H.H 2*3*18.5 + 27 = 138, last 10       |F error| <= 159e L^8, used 256
//   beta: 8e L^4, used 10     G: h_S B 6, s.H 18.5 + 9, last subtraction 4         |G error| <= 38e L^5, used 64
// The slack of more than a quarter absorbs terms in e^2, the rounding of the bounds and any order of additions. L^8 <
// 2^248, so nothing overflows.
#pragma once

#include "core/vec3.hpp"
#include "exact/circle_crossing.hpp"
#include "exact/exact_predicates.hpp"
#include "lanes/floating_point.hpp"

namespace hsp::exact {

struct FilterBounds {
  double D, A, F, B, beta, G;

  static FilterBounds for_length_squared(double L2) {
    const double L4 = L2 * L2;
    const double L = std::sqrt(L2);
    return {64 * unit_roundoff * L4 * L2, 64 * unit_roundoff * L4 * L2, 256 * unit_roundoff * L4 * L4,
            8 * unit_roundoff * L2 * L,   10 * unit_roundoff * L4,      64 * unit_roundoff * L4 * L};
  }
};

inline int certain_sign(double value, double bound) {
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

// The crossing of the circles of P and Q. n is exact before it is rounded.
inline CircleCrossing<Vec3, double> circle_crossing(const Plane &P, const Plane &Q) {
  return {to_double(cross(P.v, Q.v)),
          static_cast<double>(P.h) * to_double(Q.v) - static_cast<double>(Q.h) * to_double(P.v)};
}

inline int filter_crossing(const FilterBounds &bounds, const Sphere &sphere, const Plane &P, const Plane &Q) {
  return certain_sign(circle_crossing(P, Q).discriminant(static_cast<double>(sphere.W)), bounds.D);
}

inline int filter_side(const FilterBounds &bounds, const Plane &P, const Plane &R) {
  const double beta = static_cast<double>(R.h) * static_cast<double>(dot(P.v, P.v)) -
                      static_cast<double>(P.h) * static_cast<double>(dot(P.v, R.v));
  return -certain_sign(beta, bounds.beta);
}

// Returns whether the status of both points is certain, and stores it if so.
inline bool filter_point_status(const FilterBounds &bounds, const Sphere &sphere, const Plane &P, const Plane &Q,
                                const Plane &R, PointStatus &status) {
  const CircleCrossing<Vec3, double> crossing = circle_crossing(P, Q);
  const Vec3 &n = crossing.n;
  const Vec3 &q = crossing.q;
  const Vec3 z = to_double(R.v);
  const double B = dot(n, z);
  const Vec3 H = combine(1.0, cross(q, z), static_cast<double>(R.h), n);
  const int F = certain_sign(static_cast<double>(sphere.W) * B * B - dot(H, H), bounds.F);
  if (F == 0) return false;
  const int decider = F > 0 ? certain_sign(B, bounds.B) : certain_sign(-dot(H, n), bounds.A);
  if (decider == 0) return false;
  status = {{F > 0 ? -decider : decider, decider}, {false, false}};
  return true;
}

inline int filter_near(const FilterBounds &bounds, const Plane &P, const Plane &Q, const Plane &R, const Plane &S) {
  const CircleCrossing<Vec3, double> crossing = circle_crossing(P, Q);
  const Vec3 z = to_double(R.v);
  const double B = dot(crossing.n, z);
  const Vec3 H = combine(1.0, cross(crossing.q, z), static_cast<double>(R.h), crossing.n);
  const double G = static_cast<double>(S.h) * B - dot(to_double(S.v), H);
  return certain_sign(B, bounds.B) * certain_sign(G, bounds.G);
}

}  // namespace hsp::exact
