// The morphometric energy of a union in a periodic box, and its derivatives by the balls, by the strain and by the box.
#pragma once

#include "measure/morphometry.hpp"
#include "periodic/periodic_measures.hpp"

namespace hsp {

// Calls sink(i, gradient) for every ball i of the input, whose images move and grow with it, and returns the energy,
// all in the caller's unit. The volume is the sum of the cells. weights: weights_in_box.
template <class Sink>
MorphometricEnergy differentiate_morphometry_in_box(const PeriodicUnion &periodic, const AreaWeights &weights,
                                                    const MorphometricFactors &factors, Sink sink) {
  const Boundary &boundary = periodic.boundary();
  MorphometrySum sum(periodic.images().lattice(), weights, factors);
  const bool any_tied = has_tied_vertices(boundary);
  for (uint32_t i = 0; i < periodic.images().balls(); ++i) {
    const uint32_t ball = periodic.grid().grid_index(i);
    CurvedBallGradient own = curved_gradient_of_ball(periodic.balls(), boundary, weights, ball, any_tied);
    own.measures.measure.volume = periodic.contacts().cell_volume(ball);
    sink(i, sum.add(periodic.balls(), ball, own));
  }
  return sum.total(periodic.counts().euler());
}

// Of the weighted mean curvature, in steps.
Strain curvature_by_strain(const PeriodicUnion &periodic, const AreaWeights &weights);

// Of the energy, in the caller's unit. The Gaussian curvature does not change.
BoxGradient differentiate_morphometry_by_box(const PeriodicUnion &periodic, const AreaWeights &weights,
                                             const MorphometricFactors &factors);

}  // namespace hsp
