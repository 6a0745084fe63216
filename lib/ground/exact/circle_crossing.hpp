// Where two circles of a sphere |p|^2 = W cross, in floating point.
//
// Let the circles lie in the planes u.p = a and v.p = b, and put n = u x v, q = a v - b u. They cross iff
//   D = W n.n - q.q > 0,   in the points   p+- = (q x n +- sqrt(D) n) / n.n.
// q is orthogonal to n, so that q x n has no cancellation. Vector and Real are Vec3 and double, or several in lanes.
//
// As an example W = 25 and the planes x = 3 and y = 3: n = (0, 0, 1), q = (-3, 3, 0) and D = 25 - 18 = 7, so that the
// circles cross in (3, 3, +-sqrt(7)).
#pragma once

#include "core/vec3.hpp"

namespace hsp {

template <class Vector, class Real>
struct CircleCrossing {
  Vector n, q;
  Real nn;  // n.n

  CircleCrossing(const Vector &u, const Real &a, const Vector &v, const Real &b)
      : CircleCrossing(cross(u, v), a * v - b * u) {}
  // The same from n and q, for instance from exact integers.
  CircleCrossing(const Vector &normal, const Vector &radical) : n(normal), q(radical), nn(dot(n, n)) {}

  Real discriminant(const Real &W) const { return W * nn - dot(q, q); }
  // p+ times `scale` if root is sqrt(D), p- times `scale` if root is -sqrt(D).
  Vector point(const Real &root, double scale = 1.0) const { return (scale / nn) * (cross(q, n) + root * n); }
};

}  // namespace hsp
