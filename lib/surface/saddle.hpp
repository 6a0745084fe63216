// Saddle patches: what the probe's lower side sweeps while it rolls along an arc, touching two balls.
//
// On the circle of balls i and j, with u from c_i to c_j, e the radial unit vector and rho the circle's radius, the
// patch is  x = y + p (-cos(a) e + sin(a) u),  -t_i <= a <= t_j,  tan t_i = h_i / rho  with h_i the height of the
// circle's plane above c_i. The two balls share it at a = 0. Nothing cuts it but its own axis (PROOFS.md, section 4):
// where rho < p and the plane lies between the centres, what remains ends at the cusps, cos a = rho/p.
#pragma once

#include "core/elementary.hpp"
#include "core/vec3.hpp"

namespace hsp {

// One ball's side of an arc, all lengths in one unit, X = 2 (q - p) x u as in ArcBatch.
struct SaddleSide {
  double probe;
  double radius, other_radius;  // of the two balls, probe included
  double height, other_height;  // of the circle's plane above either centre, towards the other one
  double circle_radius;
  double angle;  // of the arc
  Vec3 axis, X;
};

// Whether the surface of this circle meets its own axis. Where rho and p are equal up to rounding both answers are
// right: the piece that is cut off is empty up to rounding.
inline bool has_cusps(const SaddleSide &side) {
  return side.circle_radius < side.probe && side.height > 0.0 && side.other_height > 0.0;
}

// Area, and three times the term of the divergence theorem about a point; arm leads from there to the circle's centre.
struct SaddleMeasure {
  double area = 0.0;
  double triple_volume = 0.0;
};

// This ball's part of the patch, -t_i <= a <= min(0, t_j), or up to its cusp: with T, S, Q, C2 and SC the integrals of
// 1, cos, sin, cos^2 and sin cos over that range,
//   area         phi p (rho T - p S)
//   vector area  p [ (S - p C2 / rho) X/2 - phi (rho Q - p SC) u ]
//   integral of (x - m).n   phi p [ (rho^2 + p^2) S - rho p (C2 + T) ]
inline SaddleMeasure measure_saddle(const SaddleSide &side, const Vec3 &arm) {
  const double rho = side.circle_radius;
  const double p = side.probe;
  if (!(side.height > 0.0) || !(rho > 0.0)) return {};
  // sin and cos of both ends.
  const double sin_a = -side.height / side.radius;
  const double cos_a = rho / side.radius;
  double sin_b = 0.0;
  double cos_b = 1.0;
  if (has_cusps(side)) {
    sin_b = -std::sqrt((p - rho) * (p + rho)) / p;
    cos_b = rho / p;
  } else if (side.other_height < 0.0) {
    sin_b = side.other_height / side.other_radius;
    cos_b = rho / side.other_radius;
  }
  const double T = arc_tangent(sin_b * cos_a - cos_b * sin_a, cos_b * cos_a + sin_b * sin_a);
  if (!(T > 0.0)) return {};
  const double S = sin_b - sin_a;
  const double Q = cos_a - cos_b;
  const double C2 = 0.5 * (T + sin_b * cos_b - sin_a * cos_a);
  const double SC = 0.5 * (sin_b - sin_a) * (sin_b + sin_a);
  const double area = side.angle * p * (rho * T - p * S);
  const double about_centre = side.angle * p * ((rho * rho + p * p) * S - rho * p * (C2 + T));
  const Vec3 vector_area =
      combine(0.5 * p * (S - p * C2 / rho), side.X, -p * side.angle * (rho * Q - p * SC), side.axis);
  return {area > 0.0 ? area : 0.0, about_centre + dot(arm, vector_area)};
}

}  // namespace hsp
