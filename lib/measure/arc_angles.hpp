// Angles of arcs and at vertices of one sphere, from exact integers rounded once. Formulas: exact_predicates.hpp for D,
// beta, Delta; at exact tangency atan2(0, 0) stands for pi/2, the limit under the symbolic inflation (Delta ~ eps
// dominates beta^2 ~ eps^2).
#pragma once

#include "core/elementary.hpp"
#include "exact/exact_predicates.hpp"

namespace hsp {

inline double limit_angle(double y, double x) {
  return y == 0.0 && x == 0.0 ? pi / 2 : arc_tangent(y, x);
}

inline double length(const exact::Vector &v) {
  return std::sqrt(static_cast<double>(exact::dot(v, v)));
}

// Half the angle of the part of circle P that ball R covers; root_D belongs to the vertices of P and R.
inline double covered_half_angle(double root_D, const exact::Plane &P, const exact::Plane &R) {
  return limit_angle(root_D * length(P.v), exact::Exact::radical_coordinate(P, R));
}

// The angle by which a loop turns at a vertex of circles P and Q, in [0, pi].
inline double exterior_angle(double root_D, const exact::Sphere &sphere, const exact::Plane &P, const exact::Plane &Q) {
  return limit_angle(std::sqrt(static_cast<double>(sphere.W)) * root_D, exact::Exact::exterior_cosine(sphere, P, Q));
}

// The angle from the direction of Q to that of R about the axis of P, in (0, 2 pi]; the branch is decided exactly.
inline double turn(const exact::Plane &P, const exact::Plane &Q, const exact::Plane &R) {
  const double sine = exact::Exact::triple_product(P.v, Q.v, R.v);
  const double cosine = exact::Exact::cross_dot_cross(P.v, Q.v, R.v);
  const double angle = arc_tangent(sine * length(P.v), cosine);
  return angle > 0.0 ? angle : angle + 2 * pi;
}

// The angle of the free arc of circle P from the exit of ball Q to the entry of ball R, in [0, 2 pi].
inline double free_arc_angle(const exact::Plane &P, const exact::Plane &Q, double root_D_exit, const exact::Plane &R,
                             double root_D_entry) {
  const bool same = Q.index == R.index;
  const double angle =
      (same ? 2 * pi : turn(P, Q, R)) - covered_half_angle(root_D_exit, P, Q) - covered_half_angle(root_D_entry, P, R);
  return angle > 0.0 ? angle : 0.0;
}

}  // namespace hsp
