// Integrated mean and Gaussian curvature of the boundary of the union.
//
// Over a sphere's faces the mean curvature is 1/r, the Gaussian one 1/r^2. Along an arc of radius rho and angle phi the
// normals turn by beta, the angle between the two outward ones: it counts as the limit of a rounded concave edge. With
//   M = sum over balls of A_i / r_i  -  1/2 sum over arcs and circles of rho phi beta
//   G = 2 pi chi(boundary)                                                               (Gauss-Bonnet)
// the layer of small width t inside the union has the volume A t - M t^2 + G t^3/3 (Steiner; Federer 1959). Each edge
// is shared by its two balls. A vertex gives 2 pi/3 less its angle to each of its balls, so that by Gauss-Bonnet on its
// faces a ball has G_i = (pi/3)(6 chi_i - V_i), with chi_i = 2 faces - loops and V_i its vertices: an integer decides.
//
// The derivatives of a weighted M, edges with the mean s of their two weights: of areas as in gradients.hpp; and with
// d the distance of the centres of balls k and j, and h_k and h_j those of their circle's plane,
//   d(rho beta) = beta drho + dd - (h_k/r_k) dr_k - (h_j/r_j) dr_j
//   drho        = (-h_k h_j dd + r_k h_j dr_k + r_j h_k dr_j) / (d rho)
//   dphi        = sum over both ends x of T.(dx - (1 - h_k/d) dc_k - (h_k/d) dc_j) / rho
// with T the unit tangent that leads out of the arc. A vertex x with y_i = x - c_i moves by y_i.dx = y_i.dc_i + r_i
// dr_i. Its three edges pull at it with -s beta/2 T each; with c_0 = y_1 x y_2 and so on, T_l is c_l / |c_l| up to its
// sign, and y_0.c_0 = +-sqrt(D)/2, so that solving the transposed system gives
//   dM/dc_i = lambda_i y_i,   dM/dr_i = lambda_i r_i,
//   lambda_i = sum over edges l of s_l beta_l c_l.c_i / (|c_l| sqrt(D))
// where all products of the y are integers: 2 y_i.y_j = r_i^2 + r_j^2 - |c_i - c_j|^2. Every ball of a vertex solves
// for its own lambda alone (edge_kernel.hpp): an edge or a vertex is cheaper to compute again than to remember.
#pragma once

#include "curvature/strain.hpp"
#include "measure/gradients.hpp"

namespace hsp {

struct BallCurvature {
  double mean = 0.0;  // lattice steps
  int32_t gauss = 0;  // 6 chi_i - V_i, in units of pi/3
};

BallCurvature curvature_of_ball(const BallSet &balls, const Boundary &boundary, uint32_t i);

// Ball k's part of a weighted M, and the derivatives of all of it by ball k.
struct MeanCurvatureGradient {
  double mean = 0.0;           // lattice steps
  Vec3 centre{0.0, 0.0, 0.0};  // without a unit, as the next one
  double radius = 0.0;
  bool one_sided = false;  // M has a kink here: spheres touch, or four meet in a vertex
};

// Asked once, as that is cheaper than at every ball.
struct CurvedSet {
  // A vertex is decided by the symbolic perturbation, four spheres or more meeting there. Molecules have none.
  bool has_tied_vertices;
  // Balls that meet have lengths whose squares doubles hold exactly. Molecules are written with few decimals, so that
  // their integers end in zeros.
  bool has_plain_squares;
};
CurvedSet curved_set(const BallSet &balls, const Boundary &boundary);

// Both in one pass over the ball's arcs.
struct CurvedBallGradient {
  BallGradient measures;
  MeanCurvatureGradient curvature;
};
CurvedBallGradient curved_gradient_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights,
                                           uint32_t k, const CurvedSet &set);

// Ball k's part of the derivatives of a weighted M by the strain, in steps: all balls' parts sum to them. The part of M
// from the vector between two balls counts half at each of them. All that a vertex adds to the derivatives by its
// balls' centres counts with their positions as seen from the vertex.
void add_curvature_strain_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights,
                                  uint32_t k, StrainSum &sum);

}  // namespace hsp
