// Derivatives of areas and volume by centres and radii (Connolly 1983, Richmond 1984), gathered ball by ball: what
// moves with ball k are the free arcs on its own sphere, and each of them bounds two areas.
//
// With R, c radii and centres, for every free arc of angle phi on the circle of k and j, from p to q counter-clockwise
// about the unit vector u from c_k to c_j, d the distance of the centres and h that of the circle's plane from c_k:
//   dA_k/dc_j = R_k [ phi (1 - h/d) u - X/d ],   X = (q - p) x u,        dA_k/dR_j = -R_k R_j phi / d
//   dA_j/dc_k = R_j [ -phi (h/d) u - X/d ],                              dA_k/dc_k = - sum over j of dA_k/dc_j
//   dA_k/dR_k = 2 A_k/R_k + sum over arcs of phi (R_k^2 + R_j^2 - d^2)/(2 d)
// and dV/dc_k is the vector area of ball k's faces, dV/dR_k = A_k.
#pragma once

#include "measure/areas.hpp"
#include "measure/free_surface.hpp"
#include "measure/loop_walk.hpp"

namespace hsp {

enum class TouchingBalls : uint8_t { meet, apart };

// Whether the derivatives count the free arcs of this circle. Spheres that touch from outside meet in one of radius 0,
// which counts as the caller wants it. A ball that touches another from inside counts as lying inside it, whatever the
// tie rule made of it.
inline bool counts(const Circle &circle, TouchingBalls touching_balls) {
  if (circle.touching == Touching::no) return true;
  return circle.touching == Touching::from_outside && touching_balls == TouchingBalls::meet;
}

// What is differentiated: S = sum over the balls of weight * area.
struct AreaWeights {
  const double *weight = nullptr;  // in the caller's order; null for all ones
  TouchingBalls touching_balls = TouchingBalls::meet;

  double of(const BallSet &balls, uint32_t i) const { return weight == nullptr ? 1.0 : weight[balls.caller[i]]; }
};

// Ball k's part, in lattice steps.
struct BallGradient {
  BallMeasure measure;
  exact::DoubleVector centre{0.0, 0.0, 0.0};       // dS/dc_k
  double radius = 0.0;                             // dS/dR_k
  exact::DoubleVector vector_area{0.0, 0.0, 0.0};  // dV/dc_k; dV/dR_k is the area
  bool one_sided = false;                          // a sphere touches this one at a free point
};
BallGradient gradient_of_ball(const BallSet &balls, const BoundaryStructure &boundary, const AreaWeights &weights,
                              uint32_t k);

// Derivatives of the area of one ball by another one, or by itself, in lattice steps.
struct AreaDerivative {
  exact::DoubleVector centre{0.0, 0.0, 0.0};
  double radius = 0.0;
  double angle = 0.0;  // of the free arcs that count
  bool one_sided = false;
};
// The length of ball i's row: itself, and the balls whose circles on it have a free piece; 0 if it has no face.
uint32_t area_row_length(const BoundaryStructure &boundary, uint32_t i);

// Calls on_part(j, derivative) for every free arc and circle on ball i, with its part of the derivatives by ball j, and
// returns those by i itself.
template <class OnPart>
AreaDerivative visit_area_row(const BallSet &balls, const BoundaryStructure &boundary, uint32_t i,
                              TouchingBalls touching_balls, OnPart on_part) {
  const LoopWalk walk(balls, boundary, i);
  const double R = balls.r[i];
  FreeSurface surface;
  AreaDerivative own;
  surface.exteriors = walk.visit(no_id, [&](const Circle &circle, double angle, const exact::DoubleVector &X) {
    surface.add_arc(walk.origin(), circle, angle, X);
    AreaDerivative part;
    part.one_sided = circle.touching != Touching::no;
    if (counts(circle, touching_balls)) {
      const double ratio = R * circle.inverse_distance;
      part.angle = angle;
      part.centre = exact::combine((R - circle.height * ratio) * angle, circle.axis, -0.5 * ratio, X);
      part.radius = -ratio * balls.r[circle.other] * angle;
      own.radius += (R * ratio - circle.height) * angle;
    }
    own.one_sided = own.one_sided || part.one_sided;
    own.centre = exact::combine(1.0, own.centre, -1.0, part.centre);
    on_part(circle.other, part);
  });
  const uint32_t faces = boundary.first_face[i + 1] - boundary.first_face[i];
  own.radius += 2 * R * surface.steradians(faces, boundary.first_loop[i + 1] - boundary.first_loop[i]);
  return own;
}

}  // namespace hsp
