// Sums of curvature over the edges and vertices of one ball, in addition to the sums over arcs of arc_sums.hpp. An edge
// is an arc at which two spheres meet at an angle. Term k of a sum goes to lane k % 4 in every kernel, so that all
// kernels give the same bits.
#pragma once

#include "measure/arc_sums.hpp"

namespace hsp {

// The edges of a batch, slot by slot.
struct EdgeBatch {
  bool has_weights = false;        // else all are 1
  bool has_plain_squares = false;  // doubles hold the squares of lengths exactly, and their sums
  double weight[ArcBatch::room];   // the weight of the other ball, finite up to the last whole register

  double weight_of(uint32_t s) const { return has_weights ? weight[s] : 1.0; }

  // Set by a kernel. pull: s beta/(rho d), with s the mean of the two balls' weights, or 0 if the spheres touch. force,
  // force_by_previous: at the vertex at which the arc starts, lambda sqrt(D) = force + (pull of the previous slot)
  // times force_by_previous.
  double pull[ArcBatch::room], force[ArcBatch::room], force_by_previous[ArcBatch::room];
  double cosine[ArcBatch::room];  // r_k r_j cos(beta), unless squares are plain
};

// Ball k's part of -sum over edges of s rho phi beta / 2, and the derivatives by ball k without those of areas.
struct EdgeSums {
  double mean;
  double centre[3];
  double radius;
};

// The kernels (edge_kernel.hpp). The batch has been evaluated. The first returns half of the sum of rho phi beta; the
// second is for a ball of this radius and weight.
HSP_KERNEL(double, sum_edges, (const BallOfSet &ball, const ArcBatch &arcs), (ball, arcs))
HSP_KERNEL(EdgeSums, differentiate_edges, (double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges),
           (radius, arcs, weight, edges))
// Whether integers below 2^51 in magnitude are multiples of a power of two from 1 to 2^20.
HSP_KERNEL(bool, are_multiples, (const double *numbers, uint32_t count, double unit), (numbers, count, unit))

}  // namespace hsp
