// Sums over the saddle patches around one ball, for kernels for registers of several widths
// (saddle_kernel.hpp): over the arcs of a batch (measure/arc_sums.hpp), with lane k % 4 for term k in every kernel.
#pragma once

#include "measure/arc_sums.hpp"

namespace hsp {

// A ball among the others, with the probe that its radius contains.
struct RolledBall {
  const double *radii;  // of all balls
  double radius;
  double probe;
  double arm[3];  // from the origin of the volume to the ball's centre
};

// Area of the ball's parts of the patches, and three times their term of the volume.
struct SaddleMeasures {
  double area;
  double triple_volume;
};

// Derivatives of the whole patches' area and volume by the ball's centre and radius, and half of the area's derivative
// by the offset t (surface_gradients.hpp).
struct SaddleDerivatives {
  SaddleMeasures measures;
  double area[4], volume[4];  // by the centre, and by the radius
  double area_offset;
};

// The circle in every slot, and in the slots behind the last that kernels read, too: its radius, NaN where doubles are
// not precise enough; and the distance of its cusps from its middle, 0 if it has none.
struct SaddleCircles {
  double radius[ArcBatch::room], half_way[ArcBatch::room];
};

// False if doubles are not precise enough for one of the circles.
HSP_KERNEL(bool, find_saddle_circles, (const ArcBatch &batch, const RolledBall &ball, SaddleCircles &circles),
           (batch, ball, circles))
HSP_KERNEL(SaddleMeasures, measure_saddles,
           (const ArcBatch &batch, const SaddleCircles &circles, const RolledBall &ball), (batch, circles, ball))
HSP_KERNEL(SaddleDerivatives, differentiate_saddles,
           (const ArcBatch &batch, const SaddleCircles &circles, const RolledBall &ball), (batch, circles, ball))

}  // namespace hsp
