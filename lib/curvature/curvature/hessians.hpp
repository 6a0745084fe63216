// Second derivatives of an energy E = tension * sum of sigma_i A_i + pressure * V by the centres of two balls, gathered
// arc by arc from the batches that areas and gradients read (measure/arc_batches.hpp).
//
//                 x         On a free arc of the circle of balls i and j: u is the unit vector from c_i to c_j, d the
//             a /   \ b     distance, h_i and h_j = d - h_i are the heights of the circle's plane along u, rho is its
//             /   e   \     radius, phi the arc's angle and e the vector from the circle's centre to a point x of it,
//       c_i *---->*----* c_j  p and q at the arc's ends; a = h_i u + e, b = e - h_j u, X = (q - p) x u, Y = p + q.
//            h_i u  h_j
//
// A patch of ball j that moves outward sweeps over the face of ball i along the arc, hence
//   d2V/dc_i dc_j = -(1/d) int a b^T dphi
// The weighted area is the derivative of V along the radii, R' = sigma, so its second derivatives are the same integral
// differentiated: h' = (R_i sigma_i - R_j sigma_j)/d is the speed of the circle's plane, and Q = R_i sigma_i - h_i h'
// is rho rho'. An end x of balls i, j, k, with x, v and w the vectors from c_i to it, to c_j and to c_k, moves by
//   [ g v x w + g_j w x x + g_k x x v ]/det,  g = R_i sigma_i, g_j = g - R_j sigma_j, g_k = g - R_k sigma_k,
// where det = x . (v x w) = -sqrt(D)/2 has the root discriminant of the vertex. The integrals themselves:
//   int e dphi = X,   int e e^T dphi = (rho^2 phi (1 - u u^T) + (X Y^T - (u x X)(u x Y)^T)/2)/2
// All other pairs have the block 0, and a row sums to 0. A circle is an arc with X = Y = 0 and without ends.
#pragma once

#include "measure/energy.hpp"

namespace hsp {

// d2E/dc_i dc_j, rows by the components of c_i.
struct HessianBlock {
  double entry[9];
};

// The velocities of the vertices of a batch as all radii grow by their weights, relative to the ball's centre.
class VertexRates {
 public:
  // False if an arc begins at a vertex in the plane of its three centres. That vertex has no velocity: it is set to 0.
  bool find(const BallSet &balls, const AreaWeights &weights, uint32_t ball, const ArcBatch &batch);
  Vec3 at(uint32_t slot) const { return {x_[slot], y_[slot], z_[slot]}; }

 private:
  double x_[ArcBatch::room], y_[ArcBatch::room], z_[ArcBatch::room];
};

// The flag of a ball with a vertex in the plane of its three centres: areas have no second derivatives there.
inline constexpr uint32_t singular_flag = 2;

// The free arcs and circles on one ball, one after the other, in the order of ArcBatches.
class HessianArcs {
 public:
  HessianArcs(const BallSet &balls, const Boundary &boundary, const EnergyTerms &terms, uint32_t ball);

  // Moves to the first or the next arc; false if there is none.
  bool next();
  uint32_t other() const { return arcs_.batch().other[slot_]; }
  // The arc's part of the block of the two balls, in the unit of E over the square of the caller's unit of length.
  HessianBlock block() const;
  // The flags of all arcs so far: one_sided_flag, singular_flag.
  uint32_t flags() const { return flags_; }

 private:
  bool next_batch();
  double growth(uint32_t i) const { return terms_.weights.of(balls_, i) * balls_.r[i]; }

  const BallSet &balls_;
  const EnergyTerms &terms_;
  const uint32_t ball_;
  const double pressure_;  // of lattice steps
  const double growth_;    // R sigma
  ArcBatches arcs_;
  VertexRates rates_;
  uint32_t slot_ = 0, count_ = 0;  // the slot of this arc, and how many slots the batch has
  uint32_t flags_ = 0;
};

}  // namespace hsp
