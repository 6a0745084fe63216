// Sums over the arcs of one ball: a batch of arcs as plain arrays, which kernels for registers of several widths fill,
// and the sums. Term k of a sum goes to lane k % 4 in every kernel, so that all kernels give the same bits.
//
// A slot of a batch holds a circle. If it has an arc, it also holds the arc of a half-edge on this circle and the
// vertex where the half-edge starts. previous[] and next[] are the slots of the half-edges before and after it in the
// loop. If a loop does not fit into the batch, there is a slot without an arc before the first of its half-edges here,
// for the circle along which the loop arrives, and one after the last, for the vertex where the last arc ends.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

// Two spheres that touch from outside meet in a circle of radius 0, exactly known from integers.
enum class Touching : uint8_t { no, yes };

// One ball of a set, for kernels: arrays of the set, and its own centre and radius.
struct BallOfSet {
  const double *xs, *ys, *zs, *rs;
  double x, y, z, r;
};

// The lanes of every sum over arcs, whatever the width of the registers: term k goes to lane k % 4.
inline constexpr uint32_t sum_lanes = 4;

struct ArcProducts;

struct ArcBatch {
  static constexpr uint32_t capacity = 32;
  static constexpr uint32_t room = capacity + sum_lanes;  // kernels read whole registers

  uint32_t count = 0;
  bool any_touching = false;  // touching[] means something only if this is set
  uint32_t other[room];       // the ball that cuts out the circle
  uint32_t previous[room], next[room];
  int64_t arc[room];               // -1 if there is an arc
  double root_discriminant[room];  // of the vertex

  // Filled in by a kernel, in this order:
  //   the sum of the exterior angles less whole turns, and the number of these turns
  //   the radius of the other ball
  //   the vector v from the ball's centre to the other one, v.v = d^2, and 2 h d, with h the height of the circle's
  //   plane along v
  //   the product of v with v of the previous slot
  //   the unit vector u of v, 1/d and 2 h
  //   twice the vertex, relative to the ball's centre
  //   the arc's angle, and X = 2 (q - p) x u; the arc runs from p to q, counter-clockwise about u
  // Slots without an arc have angle 0 and X 0, so that sums may run over all slots.
  double exterior_angles, exterior_turns;
  double other_radius[room];
  double vx[room], vy[room], vz[room], square_of_distance[room], scaled_height[room];
  double product_with_previous[room];
  double ux[room], uy[room], uz[room], inverse_distance[room], twice_height[room];
  double px[room], py[room], pz[room];
  double angle[room], Xx[room], Xy[room], Xz[room];

  Touching touching[room];
  // For weighted sums, unless all weights are 1: weight times radius of the other ball.
  bool has_weights = false;
  double other_weight[room];
  ArcProducts *products = nullptr;  // null, or the caller's room for them

  // Whether a slot has an arc or is a whole circle.
  bool has_piece(uint32_t s) const { return arc[s] != 0 || angle[s] != 0.0; }
};

// For all slots, also those that doubles do not serve: the square of v, and the square of the vector product of v with
// v of the previous slot.
struct ArcProducts {
  double square[ArcBatch::room], square_of_normal[ArcBatch::room];
};

// Sums over a batch.
struct AreaSums {
  double cosines;         // of 2 h angle
  double vector_area[3];  // eight times it
};
struct WeightedSums {
  double centre[3];
  double radius;
};
struct GradientSums {
  AreaSums areas;
  WeightedSums weighted;
};

// The kernels (arc_kernel.hpp).
//
// Evaluates circles, vertices, exterior angles and arcs of a batch, in doubles. Returns whether doubles served for
// everything. Heights of circles, vertices and angles of arcs that they did not serve are not numbers, and
// exterior_angles lacks the angles at such vertices.
HSP_KERNEL(bool, evaluate_arcs, (const BallOfSet &ball, ArcBatch &batch), (ball, batch))
// Evaluates again the arcs whose angles are not numbers, after their vertices have been found otherwise. Arcs on
// circles that doubles did not serve are left out.
HSP_KERNEL(void, complete_arcs, (ArcBatch & batch), (batch))
HSP_KERNEL(AreaSums, sum_areas, (const ArcBatch &batch, double radius), (batch, radius))
// Sums of areas and of weighted areas, in one pass.
HSP_KERNEL(GradientSums, sum_gradient, (const ArcBatch &batch, double radius, double weight), (batch, radius, weight))

}  // namespace hsp
