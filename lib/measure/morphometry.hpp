// Sums of curvatures over all balls, and the morphometric energy: linear in volume, weighted area, weighted mean
// curvature and Gaussian curvature, with its derivatives. Sums run over the balls in the caller's order.
#pragma once

#include "measure/curvature.hpp"
#include "measure/totals.hpp"

namespace hsp {

struct CurvatureTotals {
  double mean = 0.0;  // in the caller's unit
  double gauss = 0.0;
};

// The Gaussian curvature of so many thirds of pi.
inline double gauss_of_thirds(int64_t thirds) {
  return static_cast<double>(thirds) * (pi / 3);
}

// Calls sink(i, curvature) for every ball i of the input that does not only stand around, in lattice steps.
template <class Sink>
CurvatureTotals sum_curvatures(const CubeGrid &grid, const Boundary &boundary, Sink sink) {
  TreeSum mean;
  int64_t thirds = 0;
  visit_in_input_order(grid, boundary, {0, grid.own_balls()}, [&](uint32_t i, uint32_t ball) {
    const BallCurvature curvature = curvature_of_ball(grid.balls(), boundary, ball);
    mean.add(curvature.mean);
    thirds += curvature.gauss;
    sink(i, curvature);
  });
  return {grid.balls().lattice.length(mean.total()), gauss_of_thirds(thirds)};
}

struct MorphometricFactors {
  double pressure = 0.0, tension = 0.0, bending = 0.0, gaussian = 0.0;
};

// In the caller's unit.
struct MorphometricEnergy {
  double value = 0.0, volume = 0.0, area = 0.0, mean = 0.0, gauss = 0.0, by_probe = 0.0;
};

// Calls sink(i, gradient) for every ball i of the input, and returns the energy.
template <class Sink>
MorphometricEnergy differentiate_morphometry(const CubeGrid &grid, const Boundary &boundary, const AreaWeights &weights,
                                             const MorphometricFactors &factors, Sink sink) {
  const BallSet &balls = grid.balls();
  const EnergyTerms terms{weights, factors.tension, factors.pressure};
  EnergySum sum;
  TreeSum mean, by_probe;
  const bool any_tied = has_tied_vertices(boundary);
  visit_in_input_order(grid, boundary, [&](uint32_t i, uint32_t ball) {
    const CurvedBallGradient own = curved_gradient_of_ball(balls, boundary, weights, ball, any_tied);
    const MeanCurvatureGradient &curved = own.curvature;
    const double bending[] = {curved.centre.x, curved.centre.y, curved.centre.z};
    EnergyGradient gradient = gradient_of_energy(balls.lattice, terms, own.measures);
    sum.add(share_of_energy(balls, terms, ball, own.measures, gradient));
    for (int axis = 0; axis < 3; ++axis) gradient.centre[axis] += factors.bending * bending[axis];
    gradient.radius += factors.bending * curved.radius;
    gradient.one_sided = gradient.one_sided || curved.one_sided;
    mean.add(curved.mean);
    by_probe.add(gradient.radius);
    sink(i, gradient);
  });
  const Energy energy = sum.total(balls.lattice, factors.tension, factors.pressure);
  MorphometricEnergy result;
  result.volume = energy.volume;
  result.area = energy.area;
  result.mean = balls.lattice.length(mean.total());
  result.gauss = gauss_of_thirds(6 * boundary.euler());
  result.value = energy.value + factors.bending * result.mean + factors.gaussian * result.gauss;
  result.by_probe = by_probe.total();
  return result;
}

}  // namespace hsp
