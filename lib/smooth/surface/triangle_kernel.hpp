// The kernels of probe_triangles.hpp for registers of n doubles. Like everything in kernels they have
// internal linkage.
#pragma once

#include "exact/circle_crossing.hpp"
#include "lanes/angle.hpp"
#include "surface/probe_triangles.hpp"

namespace hsp {
namespace {

template <uint32_t n>
struct TriangleKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;
  using Triple = double[3][ProbeTriangles::lanes];

  static Vector load(const Triple &a, uint32_t s) { return {L::load(a[0] + s), L::load(a[1] + s), L::load(a[2] + s)}; }
  static void store(Triple &a, uint32_t s, const Vector &v) {
    L::store(a[0] + s, v.x);
    L::store(a[1] + s, v.y);
    L::store(a[2] + s, v.z);
  }
  static Vector centre(const BallArrays &balls, const uint32_t *ball) {
    return {L::gather(balls.x, ball), L::gather(balls.y, ball), L::gather(balls.z, ball)};
  }
  static Vector kept(const Mask &mask, const Vector &a) {
    return {L::kept(mask, a.x), L::kept(mask, a.y), L::kept(mask, a.z)};
  }

  // The circle of another ball on ball 0.
  struct Circle {
    Vector axis;
    Real twice_height, inverse_distance;
    Mask served;

    Circle(const BallArrays &balls, const Vector &own, const Real &radius, const uint32_t *other) {
      const Vector v = centre(balls, other) - own;
      const Real other_radius = L::gather(balls.r, other);
      const Real U = dot(v, v);
      inverse_distance = 1.0 / L::square_root(U);
      twice_height = (U + (radius - other_radius) * (radius + other_radius)) * inverse_distance;
      axis = inverse_distance * v;
      const Real most = 4.0 * (1.0 - 1.0 / 64) * radius * radius;
      served = L::both(twice_height * twice_height <= most, U <= 16.0 * radius * radius);
    }
  };

  // Doubles are precise enough under the conditions of measure/arc_kernel.hpp, with the errors stated there: the vertex
  // has an error of 377 e times the ball's radius.
  static void place(const BallArrays &balls, ProbeTriangles &t) {
    for (uint32_t s = 0; s < ProbeTriangles::lanes; s += n) {
      const Vector own = centre(balls, t.ball[0] + s);
      const Real radius = L::gather(balls.r, t.ball[0] + s);
      const Circle first(balls, own, radius, t.ball[1] + s);
      const Circle second(balls, own, radius, t.ball[2] + s);
      const CircleCrossing<Vector, Real> crossing(first.axis, first.twice_height, second.axis, second.twice_height);
      const Real root =
          L::load(t.sign + s) * L::load(t.root_discriminant + s) * (first.inverse_distance * second.inverse_distance);
      const Mask served = L::both(L::both(first.served, second.served), crossing.nn >= 1.0 / 16);
      store(t.offset, s, crossing.point(L::valid(served, root), 0.5));
    }
  }

  // The solid angle comes from the directions d, their cosines, which are exact but for rounding, and the discriminant:
  //   tan(area / 2) = det(d0, d1, d2) / (1 + d0.d1 + d1.d2 + d2.d0)        (Van Oosterom, Strackee 1983)
  // where 2 R0 R1 R2 det = sqrt(D); the vector area is half the sum over the sides of angle times normal. If two
  // directions are opposite and both terms are 0, there is no area.
  static void measure(const BallArrays &balls, ProbeTriangles &t) {
    for (uint32_t s = 0; s < ProbeTriangles::lanes; s += n) {
      Vector from_first[3], corner[3];
      Real radius[3], inverse[3];
      const Vector offset = load(t.offset, s);
      const Vector first = centre(balls, t.ball[0] + s);
      for (int k = 0; k < 3; ++k) {
        from_first[k] = centre(balls, t.ball[k] + s) - first;
        radius[k] = L::gather(balls.r, t.ball[k] + s);
        inverse[k] = 1.0 / radius[k];
        corner[k] = inverse[k] * (from_first[k] - offset);
        store(t.corner[k], s, corner[k]);
      }
      const Mask mirrored = L::load(t.sign + s) > 0.0;
      Real denominator = 2 * radius[0] * radius[1] * radius[2];
      Real error = L::all(0.0);
      Vector area{L::all(0.0), L::all(0.0), L::all(0.0)};
      Mask directed = denominator == denominator;
      for (int k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3;
        const int b = (k + 2) % 3;
        const Vector between = from_first[b] - from_first[a];
        const Real twice_cosine = radius[a] * radius[a] + radius[b] * radius[b] - dot(between, between);
        denominator += radius[k] * twice_cosine;
        const Real cosine = 0.5 * twice_cosine * inverse[a] * inverse[b];
        // The vertex lies on the side of the balls' plane that its sign gives; the triple product has the opposite
        // sign.
        const Vector normal = cross(corner[a], corner[b]);
        const Real sine = L::square_root(dot(normal, normal));
        const Mask proper = sine > 0.0;
        const Real scale = L::negate_if(mirrored, 1.0 / sine);
        const Vector inward = scale * normal;
        const Real own_error = (inverse[a] + inverse[b]) / sine;
        error = L::select(own_error > error, own_error, error);
        const Real angle = turn_angle<n>(cosine, L::select(proper, sine, L::all(1.0)));
        area = area + 0.5 * angle * inward;
        directed = L::both(directed, proper);
        store(t.inward[k], s, inward);
        L::store(t.cosine[k] + s, cosine);
      }
      const Real root = L::load(t.root_discriminant + s);
      const Mask has_angle = (root > 0.0) | (denominator < 0.0) | (denominator > 0.0);
      const Real half = L::kept(has_angle, turn_angle<n>(denominator, root));
      L::store(t.side_error + s, error);
      L::store(t.steradians + s, L::select(directed, 2.0 * half, L::all(-1.0)));
      store(t.vector_area, s, kept(directed, area));
    }
  }
};

}  // namespace
}  // namespace hsp
