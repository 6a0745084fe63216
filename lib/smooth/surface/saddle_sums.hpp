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
  double area_centre[3], volume_centre[3];
  double area_radius, volume_radius;
  double area_offset;
};

// The radius of the circle in every slot, and in those behind the last that kernels read along; not a number where
// doubles do not serve. False if there is such a one.
HSP_KERNEL(bool, find_circle_radii, (const ArcBatch &batch, double radius, double (&circle_radius)[ArcBatch::room]),
           (batch, radius, circle_radius))
HSP_KERNEL(SaddleMeasures, measure_saddles,
           (const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room], const RolledBall &ball),
           (batch, circle_radius, ball))
HSP_KERNEL(SaddleDerivatives, differentiate_saddles,
           (const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room], const RolledBall &ball),
           (batch, circle_radius, ball))

}  // namespace hsp
