// Integrated mean and Gaussian curvature of the boundary of the union.
//
// On a sphere's faces the mean curvature is 1/r, the Gaussian one 1/r^2. At an arc of radius rho and angle phi the
// outward normal turns by beta, the angle between the normals of both spheres: the arc counts as the limit of a rounded
// concave edge. With
//   M = sum over balls of A_i / r_i  -  1/2 sum over arcs and circles of rho phi beta
//   G = 2 pi chi(boundary)                                                               (Gauss-Bonnet)
// the layer of small width t inside the union has the volume A t - M t^2 + G t^3/3 (Steiner; Federer 1959). Half of
// each edge counts for each of its two balls. A vertex gives each of its balls 2 pi/3 less its angle there. So by
// Gauss-Bonnet on its faces a ball has G_i = (pi/3)(6 chi_i - V_i), with chi_i = 2 faces - loops and V_i its number of
// vertices: an integer times pi/3.
//
// Derivatives of a weighted M, in which an edge has the mean s of the weights of its balls: those of areas are as in
// gradients.hpp. For edges let d be the distance of the centres of balls k and j, and h_k and h_j the distances of
// their circle's plane from these:
//   d(rho beta) = beta drho + dd - (h_k/r_k) dr_k - (h_j/r_j) dr_j
//   drho        = (-h_k h_j dd + r_k h_j dr_k + r_j h_k dr_j) / (d rho)
//   dphi        = sum over both ends x of T.(dx - (1 - h_k/d) dc_k - (h_k/d) dc_j) / rho
// with T the unit tangent that leads out of the arc. Let y_i = x - c_i for a vertex x: it moves by y_i.dx = y_i.dc_i +
// r_i dr_i. Each of its three edges contributes -s beta/2 T. With c_0 = y_1 x y_2 and so on, T_l is c_l / |c_l| up to
// its sign, and y_0.c_0 = +-sqrt(D)/2, so that solving the transposed system gives
//   dM/dc_i = lambda_i y_i,   dM/dr_i = lambda_i r_i,
//   lambda_i = sum over edges l of s_l beta_l c_l.c_i / (|c_l| sqrt(D))
// where all products of the y are integers: 2 y_i.y_j = r_i^2 + r_j^2 - |c_i - c_j|^2. Each ball of a vertex solves for
// its own lambda alone (edge_kernel.hpp): it is cheaper to compute an edge or a vertex again than to store it.
#pragma once

#include "curvature/strain.hpp"
#include "measure/gradients.hpp"

namespace hsp {

struct BallCurvature {
  double mean = 0.0;  // lattice steps
  int32_t gauss = 0;  // 6 chi_i - V_i, in units of pi/3
};

BallCurvature curvature_of_ball(const BallSet &balls, const Boundary &boundary, uint32_t i);

// Ball k's part of a weighted M, and the derivatives of the whole M by ball k.
struct MeanCurvatureGradient {
  double mean = 0.0;           // lattice steps
  Vec3 centre{0.0, 0.0, 0.0};  // derivative by the centre, without a unit
  double radius = 0.0;         // derivative by the radius, without a unit
  bool one_sided = false;      // M has a kink here: spheres touch, or four meet in a vertex
};

// Properties of a set, found once, which is cheaper than at every ball.
struct CurvedSet {
  // Whether a vertex is decided by the symbolic perturbation, since four spheres or more meet there. Molecules have
  // none.
  bool has_tied_vertices;
  // Whether doubles hold the squares of all lengths between balls that meet exactly. They do for molecules, which are
  // written with few decimals, so that their integers end in zeros.
  bool has_plain_squares;
};
CurvedSet curved_set(const BallSet &balls, const Boundary &boundary);

// Derivatives of measures and of mean curvature, in one pass over the ball's arcs.
struct CurvedBallGradient {
  BallGradient measures;
  MeanCurvatureGradient curvature;
};
CurvedBallGradient curved_gradient_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights,
                                           uint32_t k, const CurvedSet &set);

// Adds ball k's part of the derivatives of a weighted M by the strain, in steps; the parts of all balls sum to these.
// The term of a vector between two balls counts half at each of them. The terms of a vertex in the derivatives by its
// balls' centres count with the positions of these relative to the vertex.
void add_curvature_strain_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights,
                                  uint32_t k, StrainSum &sum);

}  // namespace hsp
