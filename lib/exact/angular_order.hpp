// The order of directions around an axis, exactly. Used for the mid-points of the covered arcs of a circle: ball Q
// covers an arc whose mid-point lies in the direction of v_Q, whatever the arc's size. For the planes with a free end
// point this is the order of the free intervals, and no two of them tie: so no square root and no symbolic perturbation
// is needed (PROOFS.md, section 4).
#pragma once

#include "exact/filter.hpp"

namespace hsp::exact {

// Sign of (u x v).z. The cross product is exact, so the sum of three products of doubles has an error of at most 5e
// times the sum of their sizes: e each for the two conversions and the product, two additions.
inline int orientation(const Vector &u, const Vector &v, const Vector &z) {
  const Vec3 n = to_double(cross(u, v));
  const double x = n.x * static_cast<double>(z.x);
  const double y = n.y * static_cast<double>(z.y);
  const double w = n.z * static_cast<double>(z.z);
  const int sign = certain_sign(x + y + w, 8 * unit_roundoff * (std::fabs(x) + std::fabs(y) + std::fabs(w)));
  return sign != 0 ? sign : Exact::triple_product_sign(u, v, z);
}

// 0 if v lies in the half-turn [0, pi) counter-clockwise from reference about axis, else 1. Directions are taken modulo
// the axis.
inline int half_turn(const Vector &axis, const Vector &reference, const Vector &v) {
  const int side = orientation(axis, reference, v);
  if (side != 0) return side > 0 ? 0 : 1;
  return Exact::cross_dot_cross_sign(axis, reference, v) > 0 ? 0 : 1;
}

// Whether v comes strictly before w when turning counter-clockwise from reference about axis.
inline bool counter_clockwise_before(const Vector &axis, const Vector &reference, const Vector &v, const Vector &w) {
  const int half_v = half_turn(axis, reference, v);
  const int half_w = half_turn(axis, reference, w);
  if (half_v != half_w) return half_v < half_w;
  return orientation(axis, v, w) > 0;
}

// Whether x lies inside the counter-clockwise turn that leads from `from` to `to`, ends excluded. Equal ends are a
// whole turn, which contains every x.
inline bool strictly_between(const Vector &axis, const Vector &from, const Vector &x, const Vector &to) {
  if (orientation(axis, from, to) == 0 && Exact::cross_dot_cross_sign(axis, from, to) > 0) return true;
  return counter_clockwise_before(axis, from, x, to);
}

}  // namespace hsp::exact
