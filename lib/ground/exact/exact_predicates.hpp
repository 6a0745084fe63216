// The exact stage of the predicates, with the symbolic perturbation. Source: Simulation of Simplicity (Edelsbrunner and
// Muecke, ACM TOG 9, 1990), applied to the weights alone: each ball grows in proportion, and infinitely less by other
// amounts. Every predicate is a polynomial of degree at most 2 in the weights. Its sign is that of the value. If the
// value is 0, its sign is that of the change as balls grow in proportion. If this change is 0, too, the sign of a
// quadratic predicate is that of the second derivative, which is negative; the sign of a linear predicate is that of
// the changes with the other amounts. The proofs are in PROOFS.md, sections 1 to 3.
#pragma once

#include "exact/plane.hpp"
#include "exact/wide_integer.hpp"

namespace hsp::exact {

// A sign that is never 0, and whether it comes from the symbolic perturbation because the value was 0. (Circles with
// parallel axes never cross, whatever the perturbation, so they are not tied even if D is 0.)
struct Sign {
  int sign;
  bool tied;
};

// Whether the two common points p+ and p- of the circles of P and Q lie inside (+1) or outside (-1) a third ball R. A
// point is tied if it lies exactly on the third sphere (or virtual plane) before the perturbation. Index 0 is p-, index
// 1 is p+.
struct PointStatus {
  int side[2];
  bool tied[2];
};

// p+ and p- are (q x n + s sqrt(D) n)/N for s = +1 and s = -1, with n = u x v. Let circle P run counter-clockwise about
// u: then its part inside Q goes from p- to p+.
template <class Limb>
struct ExactPredicates {
  // +1: the circles of P and Q on the sphere cross (in two points); -1: they do not.
  static Sign crossing(const Sphere &sphere, const Plane &P, const Plane &Q);
  // For circles that do not cross: +1 if circle P lies inside half-space R, else -1.
  static Sign side(const Sphere &sphere, const Plane &P, const Plane &R);
  // For circles P, Q that cross: whether their common points lie inside R.
  static PointStatus point_status(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R);
  // For four balls whose planes meet in one point, their power vertex (B not 0): +1 if it is nearer to them than to
  // ball S, in power distance, else -1. P, Q and R may be virtual planes.
  static Sign near(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R, const Plane &S);

  // Exact values, rounded once, for metric quantities.
  static double discriminant(const Sphere &sphere, const Plane &P,
                             const Plane &Q);                               // D, half a Cayley-Menger determinant
  static double radical_coordinate(const Plane &P, const Plane &R);         // beta = h_R u.u - h_P u.z
  static double circle_discriminant(const Sphere &sphere, const Plane &P);  // Delta = W u.u - h_P^2
  static double exterior_cosine(const Sphere &sphere, const Plane &P, const Plane &Q);  // W u.v - h_P h_Q
  static double triple_product(const Vector &u, const Vector &v, const Vector &z);      // (u x v).z
  static int triple_product_sign(const Vector &u, const Vector &v, const Vector &z);
  static double cross_dot_cross(const Vector &u, const Vector &v, const Vector &z);  // (u x v).(u x z)
  static int cross_dot_cross_sign(const Vector &u, const Vector &v, const Vector &z);
  static void radical_vector(const Plane &P, const Plane &Q, double q[3]);  // q = h_P v - h_Q u
};

using Exact = ExactPredicates<FastLimb>;

}  // namespace hsp::exact
