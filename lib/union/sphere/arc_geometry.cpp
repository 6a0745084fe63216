#include "sphere/arc_geometry.hpp"

#include "exact/discriminant.hpp"

namespace hsp {

using exact::Exact;
using exact::Plane;
using exact::Sphere;

namespace {

// At exact tangency atan2(0, 0) stands for pi/2, the limit under the symbolic perturbation (Delta ~ eps dominates
// beta^2 ~ eps^2).
double limit_angle(double y, double x) {
  return y == 0.0 && x == 0.0 ? pi / 2 : arc_tangent(y, x);
}

double length(const exact::Vector &v) {
  return std::sqrt(static_cast<double>(dot(v, v)));
}

// A complex number of any length, which stands for its angle: products add angles.
struct Complex {
  double x, y;

  friend Complex operator*(const Complex &a, const Complex &b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
  }
  Complex conjugate() const { return {x, -y}; }
};

}  // namespace

CircleGeometry::CircleGeometry(const BallSet &balls, uint32_t own, uint32_t other)
    : CircleGeometry(exact::sphere_of(balls.ball(own)), exact::plane_of(balls.ball(own), balls.ball(other))) {}

// Planes are in the coordinates y = 2 p (plane.hpp).
Vec3 crossing_point(const Plane &P, const Plane &Q, int sign, double root_D) {
  double q[3];
  Exact::radical_vector(P, Q, q);
  const CircleCrossing<Vec3, double> crossing(exact::to_double(cross(P.v, Q.v)), {q[0], q[1], q[2]});
  return crossing.point(sign > 0 ? root_D : -root_D, 0.5);
}

// In find(), D in doubles is off by no more than the filter's bound, and q by 6e L^3 (filter.hpp). If D is 2^40 times
// its bound or more, at least L^6/128, its relative error is below 2^-40. As D <= W N and |q| <= L |n|, the error of D
// is at most 12e L^4 |n| + 11e L^2 |n|^2 and that of the position below 100e L.
CrossingPointFinder::CrossingPointFinder(const Sphere &sphere, double length_squared)
    : sphere_(sphere), well_conditioned_(0x1p40 * exact::FilterBounds::for_length_squared(length_squared).D) {}

CrossingPointFinder::Point CrossingPointFinder::find_exactly(const Plane &P, const Plane &Q) const {
  const double root_D = std::sqrt(exact::discriminant(sphere_, P, Q));
  return {root_D, crossing_point(P, Q, +1, root_D)};
}

double exterior_angle(double root_D, const Sphere &sphere, const Plane &P, const Plane &Q) {
  return limit_angle(std::sqrt(static_cast<double>(sphere.W)) * root_D, Exact::exterior_cosine(sphere, P, Q));
}

// The angle from the direction of Q to that of R about the axis of P, less half of the arc that Q covers and half of
// the arc that R covers.
double arc_angle(const Plane &P, const Plane &Q, double root_D_exit, const Plane &R, double root_D_entry) {
  const bool same = Q.index == R.index;
  const double distance = length(P.v);
  const Complex between =
      same ? Complex{1.0, 0.0}
           : Complex{Exact::cross_dot_cross(P.v, Q.v, R.v), Exact::triple_product(P.v, Q.v, R.v) * distance};
  const Complex half_exit{Exact::radical_coordinate(P, Q), root_D_exit * distance};
  const Complex half_entry{Exact::radical_coordinate(P, R), root_D_entry * distance};
  // One arc tangent of the product. Every factor has a relative error of a few units, so the angle has an absolute
  // error of a few units. Close to the branch cut at angle 0 the exact signs of the three factors decide.
  const Complex product = between * (half_exit * half_entry).conjugate();
  const double angle = arc_tangent(product.y, product.x);
  if (angle > branch_cut_margin) return angle;
  if (angle < -branch_cut_margin) return angle + 2 * pi;
  const double turn = same ? 2 * pi : arc_tangent(between.y, between.x);
  const double parts = (turn > 0.0 ? turn : turn + 2 * pi) - limit_angle(half_exit.y, half_exit.x) -
                       limit_angle(half_entry.y, half_entry.x);
  return parts > 0.0 ? parts : 0.0;
}

double turn_about(const Vec3 &axis, const Vec3 &from, const Vec3 &to) {
  const double angle = arc_tangent(dot(axis, cross(from, to)), dot(from, to));
  return angle < 0.0 ? angle + 2 * pi : angle;
}

}  // namespace hsp
