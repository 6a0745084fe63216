// Sums over the arcs of one ball, as plain arrays that kernels for registers of several widths fill: a batch
// of arcs, and the sums. Term k of a sum goes to lane k % 4 in every kernel, so that all give the same bits.
//
// A slot of a batch holds a circle, and if it has an arc the arc of a half-edge on this circle and the vertex where the
// half-edge starts. previous[] and next[] are the slots of the half-edges before and after it. A loop that does not fit
// into the batch has a slot without an arc before the first and after the last of its half-edges here, for their other
// circle and their other vertex.
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
  bool any_touching = false;  // touching[] holds something only if it is set
  uint32_t other[room];       // the ball that cuts out the circle
  uint32_t previous[room], next[room];
  int64_t arc[room];               // -1 if there is an arc
  double root_discriminant[room];  // of the vertex

  // Filled in by a kernel: the sum of the exterior angles, less whole turns, and the number of these; the radius of the
  // other ball; the vector v from the ball's centre to that ball's, its square and 2 h d, with its length d and the
  // height h of the circle's plane along it; its product with v of the previous slot; its unit vector u, 1/d and 2 h;
  // twice the vertex, from the ball's centre; the arc's angle, and X = 2 (q - p) x u, with its ends p and q such that
  // it runs from p to q counter-clockwise about u. Slots without an arc have angle 0 and X 0, so that sums may run over
  // all of them.
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
  ArcProducts *products = nullptr;  // where a caller wants them

  // Whether a slot has an arc or is a whole circle.
  bool has_piece(uint32_t s) const { return arc[s] != 0 || angle[s] != 0.0; }
};

// Of all slots, also where doubles do not serve: the square of v, and that of its vector product with v of the previous
// slot.
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
// Circles, vertices, exterior angles and arcs of a batch, in doubles. True if doubles served for everything; else what
// they did not serve is not a number: heights of circles, vertices, angles of arcs; and exterior_angles lacks those.
HSP_KERNEL(bool, evaluate_arcs, (const BallOfSet &ball, ArcBatch &batch), (ball, batch))
// Once more the arcs whose angles are not numbers, but for those on circles that doubles did not serve: their vertices
// have been found elsewhere.
HSP_KERNEL(void, complete_arcs, (ArcBatch & batch), (batch))
HSP_KERNEL(AreaSums, sum_areas, (const ArcBatch &batch, double radius), (batch, radius))
// With weights, too, in one pass.
HSP_KERNEL(GradientSums, sum_gradient, (const ArcBatch &batch, double radius, double weight), (batch, radius, weight))

}  // namespace hsp
