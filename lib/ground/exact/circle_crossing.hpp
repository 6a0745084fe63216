// Where two circles of a sphere |p|^2 = W cross, in floating point.
//
// Let the circles lie in the planes u.p = a and v.p = b, and put n = u x v, q = a v - b u. They cross iff
//   D = W n.n - q.q > 0,   in the points   p+- = (q x n +- sqrt(D) n) / n.n.
// q is orthogonal to n, so that q x n has no cancellation. Vector and Real are Vec3 and double, or their lanes.
#pragma once

#include "core/vec3.hpp"

namespace hsp {

template <class Vector, class Real>
struct CircleCrossing {
  Vector n, q;
  Real nn;  // n.n

  CircleCrossing(const Vector &u, const Real &a, const Vector &v, const Real &b)
      : CircleCrossing(cross(u, v), a * v - b * u) {}
  // n and q from elsewhere, for instance from exact integers.
  CircleCrossing(const Vector &normal, const Vector &radical) : n(normal), q(radical), nn(dot(n, n)) {}

  Real discriminant(const Real &W) const { return W * nn - dot(q, q); }
  // scale p+ for root = sqrt(D), scale p- for its negative.
  Vector point(const Real &root, double scale = 1.0) const { return (scale / nn) * (cross(q, n) + root * n); }
};

// The same for unit vectors u and v with g = u.v. Then q x n = (a - g b) u + (b - g a) v and n.n = 1 - g^2, which takes
// fewer operations where g is known.
struct UnitCircleCrossing {
  double nn;

  UnitCircleCrossing(const Vec3 &u, double a, const Vec3 &v, double b, double g)
      : nn(1.0 - g * g), u_(u), v_(v), along_u_(a - g * b), along_v_(b - g * a) {}

  // scale q x n and scale n
  Vec3 scaled_middle(double scale) const { return (along_u_ * scale) * u_ + (along_v_ * scale) * v_; }
  Vec3 scaled_normal(double scale) const { return scale * cross(u_, v_); }

 private:
  Vec3 u_, v_;
  double along_u_, along_v_;
};

}  // namespace hsp
