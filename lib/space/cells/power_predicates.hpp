// Questions about power cells in a cube, decided by integers with a symbolic perturbation by ranks alone
// (exact/PROOFS.md, section 3).
//
// One ball, with centre c and squared radius w, is the origin: y = 2 (x - c), and its sphere is |y|^2 = W. The radical
// plane of balls a and b is v.y = h with v = c_b - c_a and h = h_b - h_a, where h_j = |c_j - c|^2 + w - w_j. A point
// with less power to a than to b has v.y <= h. The perturbation adds eps_a - eps_b to h. Sides of the cube have unit
// normals and are not perturbed.
//
// The balls need not meet each other; they meet one cube, or two with a common side. So |v| and |y| are below 2^34 and
// |h| below 2^67. In the notation of exact/PROOFS.md, with vertices inside the cubes: |n| < 2^68, |B| < 2^102, |H| <
// 2^137, |s.H| and |h B| < 2^171, W B^2 and H.H < 2^274, |q| < 2^102, D < 2^206, |A| < 2^206. The proofs there hold
// here, too: each answer is the sign of a polynomial at weights in general position.
#pragma once

#include "cells/cube_frame.hpp"
#include "exact/wide_integer.hpp"

namespace hsp {

class PowerPredicates {
 public:
  PowerPredicates(const BallSet &balls, uint32_t origin, const CubeFrame &frame)
      : balls_(balls), frame_(frame), origin_(origin), centre_(balls.ball(origin).centre) {}

  // The side of plane S on which the common point of P, Q and R lies: +1 the near side, -1 the far side. 0 if S goes
  // through that point for all weights: then the pairs of balls of the planes are the edges of a cycle.
  int side_of(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R, const PowerPlane &S) const;
  // Whether the common point of P, Q and R lies outside the origin ball. Here and below each plane is the radical plane
  // of the origin ball and another one, or a side.
  bool is_outside(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R) const;
  // Whether the line of P and Q meets the origin ball.
  bool meets_line(const PowerPlane &P, const PowerPlane &Q) const;
  // The side of R on which the point of the line of P and Q lies that is nearest to the centre: +1 the near side, -1
  // the far side. R may be any plane.
  int side_of_middle(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R) const;
  // Whether an edge is outside the ball as a whole, if its ends are. It is on the line of P and Q, from R1 to R2.
  bool is_free(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R1, const PowerPlane &R2) const {
    return !meets_line(P, Q) || side_of_middle(P, Q, R1) < 0 || side_of_middle(P, Q, R2) < 0;
  }
  // Whether plane P meets the origin ball, in a disc; and the side of R on which the centre of that disc lies.
  bool meets_plane(const PowerPlane &P) const;
  int side_of_disc(const PowerPlane &P, const PowerPlane &R) const;
  // The side of P on which the centre of the origin ball lies.
  int side_of_centre(const PowerPlane &P) const;
  // Whether the common point of P, Q and R is at least as far as `point` in the direction from the centre to `point`.
  bool reaches(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R, const exact::Vector &point) const;
  // The common point of P, Q and R, rounded, as y.
  Vec3 common_point(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R) const;

 private:
  struct Numbers;

  const BallSet &balls_;
  const CubeFrame &frame_;
  uint32_t origin_;
  exact::Vector centre_;
};

}  // namespace hsp
