// Angles of arcs and at vertices of one sphere, from exact integers rounded once. Formulas: exact_predicates.hpp for D,
// beta, Delta; at exact tangency atan2(0, 0) stands for pi/2, the limit under the symbolic inflation (Delta ~ eps
// dominates beta^2 ~ eps^2).
#pragma once

#include "core/elementary.hpp"
#include "exact/exact_predicates.hpp"
#include "model/ball_set.hpp"

namespace hsp {

inline double limit_angle(double y, double x) {
  return y == 0.0 && x == 0.0 ? pi / 2 : arc_tangent(y, x);
}

inline double length(const exact::Vector &v) {
  return std::sqrt(static_cast<double>(dot(v, v)));
}

// The angle by which a loop turns at a vertex of circles P and Q, in [0, pi].
inline double exterior_angle(double root_D, const exact::Sphere &sphere, const exact::Plane &P, const exact::Plane &Q) {
  return limit_angle(std::sqrt(static_cast<double>(sphere.W)) * root_D, exact::Exact::exterior_cosine(sphere, P, Q));
}

// A direction in the plane, of any length: an angle before its arc tangent is taken.
struct Complex {
  double x, y;

  friend Complex operator*(const Complex &a, const Complex &b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
  }
  Complex conjugate() const { return {x, -y}; }
};

// The angle of the free arc of circle P from the exit of ball Q to the entry of ball R, in [0, 2 pi]: from the
// direction of Q to that of R about the axis of P, less half of what Q covers and half of what R covers.
class FreeArc {
 public:
  FreeArc(const exact::Plane &P, const exact::Plane &Q, double root_D_exit, const exact::Plane &R, double root_D_entry)
      : same_(Q.index == R.index) {
    const double distance = length(P.v);
    turn_ = same_ ? Complex{1.0, 0.0}
                  : Complex{exact::Exact::cross_dot_cross(P.v, Q.v, R.v),
                            exact::Exact::triple_product(P.v, Q.v, R.v) * distance};
    half_exit_ = {exact::Exact::radical_coordinate(P, Q), root_D_exit * distance};
    half_entry_ = {exact::Exact::radical_coordinate(P, R), root_D_entry * distance};
  }

  double angle() const {
    // One arc tangent of the product; every factor has a relative error of a few units, so the angle has an absolute
    // one. Close to the cut at angle 0 rounding could turn 0 into 2 pi, so there the exact signs of the three parts
    // decide.
    constexpr double branch_cut_margin = 0x1p-20;
    const Complex product = turn_ * (half_exit_ * half_entry_).conjugate();
    const double angle = arc_tangent(product.y, product.x);
    if (angle > branch_cut_margin) return angle;
    if (angle < -branch_cut_margin) return angle + 2 * pi;
    const double to_view = same_ ? 2 * pi : arc_tangent(turn_.y, turn_.x);
    const double parts = (to_view > 0.0 ? to_view : to_view + 2 * pi) - limit_angle(half_exit_.y, half_exit_.x) -
                         limit_angle(half_entry_.y, half_entry_.x);
    return parts > 0.0 ? parts : 0.0;
  }

 private:
  bool same_;
  Complex turn_, half_exit_, half_entry_;
};

// Where a vertex lies relative to the centre of one of its balls, in lattice steps.
void vertex_offset(const exact::Plane &P, const exact::Plane &Q, int sign, double root_D, double offset[3]);

// The circle of two spheres, in lattice steps, relative to the centre of the first ball; the axis is a unit vector from
// that ball towards the second.
struct CircleGeometry {
  double centre[3];
  double axis[3];
  double radius;
};
CircleGeometry circle_geometry(const BallSet &balls, uint32_t first, uint32_t second);

}  // namespace hsp
