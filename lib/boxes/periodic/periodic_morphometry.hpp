// The morphometric energy of a union in a periodic box, and its derivatives by the balls, by the strain and by the box.
#pragma once

#include "curvature/morphometry.hpp"
#include "periodic/periodic_measures.hpp"

namespace hsp {

// Calls sink(i, gradient) for every ball i of the input, whose images move and grow with it, from the tasks of the
// executor, all in the caller's unit and frame. The volume is the sum of the shares. weights: weights_in_box(). False
// if the executor fails.
template <class Sink>
bool differentiate_morphometry_in_box(const Executor &executor, const PeriodicUnion &periodic,
                                      const AreaWeights &weights, const MorphometricFactors &factors,
                                      MorphometricEnergy &energy, Sink sink) {
  const Boundary &boundary = periodic.boundary();
  const MorphometryTerms terms{periodic.images().lattice(), weights, factors};
  const CurvedSet set = curved_set(periodic.balls(), boundary);
  const auto visit = [&](IdRange range, MorphometrySum &sum) {
    for (uint32_t i = range.first; i < range.last; ++i) {
      const uint32_t ball = periodic.grid().grid_index(i);
      CurvedBallGradient own = curved_gradient_of_ball(periodic.balls(), boundary, weights, ball, set);
      own.measures.measure.volume = periodic.contacts().share_volume(ball);
      EnergyGradient gradient = terms.add(periodic.balls(), ball, own, sum);
      periodic.images().box().frame().turn_back(gradient.centre);
      sink(i, gradient);
    }
  };
  return terms.sum(executor, periodic.images().balls(), periodic.counts().euler(), visit, energy);
}

// The derivative of the weighted mean curvature by the strain, in steps and in the frame of the box.
Strain curvature_by_strain(const PeriodicUnion &periodic, const AreaWeights &weights);

// The derivatives of the energy, in the caller's unit and frame. The Gaussian curvature does not change.
BoxGradient box_gradient_of_morphometry(const PeriodicUnion &periodic, const AreaWeights &weights,
                                        const MorphometricFactors &factors);

}  // namespace hsp
