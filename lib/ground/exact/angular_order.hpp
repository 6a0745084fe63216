// The order of directions around an axis, exactly. It is used for the mid-points of the covered arcs of a circle: the
// arc that ball Q covers has its mid-point in the direction of v_Q, whatever the arc's size. For planes with a free end
// point this is the order of the free intervals, and no two mid-points tie: so neither square roots nor the symbolic
// perturbation are needed (PROOFS.md, section 4).
#pragma once

#include "exact/filter.hpp"

namespace hsp::exact {

// Sign of (u x v).z, with n = u x v, which is exact before it is converted to doubles. So the sum of three products of
// doubles has an error of at most 5e times the sum of their sizes: e for each of two conversions, the product and two
// additions.
inline int orientation(const Vector &u, const Vector &v, const Vec3 &n, const Vector &z) {
  const double x = n.x * static_cast<double>(z.x);
  const double y = n.y * static_cast<double>(z.y);
  const double w = n.z * static_cast<double>(z.z);
  const int sign = certain_sign(x + y + w, 8 * unit_roundoff * (std::fabs(x) + std::fabs(y) + std::fabs(w)));
  return sign != 0 ? sign : Exact::triple_product_sign(u, v, z);
}
inline int orientation(const Vector &u, const Vector &v, const Vector &z) {
  return orientation(u, v, to_double(cross(u, v)), z);
}

// The order in which a counter-clockwise turn about an axis passes directions, from a reference on. Directions count by
// their components across the axis.
class TurningOrder {
 public:
  TurningOrder(const Vector &axis, const Vector &reference)
      : axis_(axis), reference_(reference), normal_(to_double(cross(axis, reference))) {}

  // 0 if v lies in the half-turn [0, pi) from the reference, else 1.
  int half_turn(const Vector &v) const {
    const int side = orientation(axis_, reference_, normal_, v);
    if (side != 0) return side > 0 ? 0 : 1;
    return Exact::cross_dot_cross_sign(axis_, reference_, v) > 0 ? 0 : 1;
  }
  // Whether v comes strictly before w.
  bool before(const Vector &v, const Vector &w) const {
    const int half_v = half_turn(v);
    const int half_w = half_turn(w);
    if (half_v != half_w) return half_v < half_w;
    return orientation(axis_, v, w) > 0;
  }

 private:
  Vector axis_, reference_;
  Vec3 normal_;
};

inline int half_turn(const Vector &axis, const Vector &reference, const Vector &v) {
  return TurningOrder(axis, reference).half_turn(v);
}
inline bool counter_clockwise_before(const Vector &axis, const Vector &reference, const Vector &v, const Vector &w) {
  return TurningOrder(axis, reference).before(v, w);
}

// Whether x lies inside the counter-clockwise turn from `from` to `to`, ends excluded. Equal ends mean a whole turn,
// which contains every x.
inline bool strictly_between(const Vector &axis, const Vector &from, const Vector &x, const Vector &to) {
  if (orientation(axis, from, to) == 0 && Exact::cross_dot_cross_sign(axis, from, to) > 0) return true;
  return counter_clockwise_before(axis, from, x, to);
}

}  // namespace hsp::exact
