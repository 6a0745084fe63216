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

// Calls sink(i, curvature) for every ball i of the input that is not in the halo, in the unit of this lattice,
// as are the sums.
template <class Sink>
CurvatureTotals sum_curvatures(const CubeGrid &grid, const Boundary &boundary, const exact::Lattice &lattice,
                               Sink sink) {
  TreeSum mean;
  int64_t thirds = 0;
  visit_in_input_order(grid, boundary, {0, grid.own_balls()}, [&](uint32_t i, uint32_t ball) {
    BallCurvature curvature = curvature_of_ball(grid.balls(), boundary, ball);
    mean.add(curvature.mean);
    thirds += curvature.gauss;
    curvature.mean = lattice.length(curvature.mean);
    sink(i, curvature);
  });
  return {lattice.length(mean.total()), gauss_of_thirds(thirds)};
}

struct MorphometricFactors {
  double pressure = 0.0, tension = 0.0, bending = 0.0, gaussian = 0.0;
};

// In the caller's unit.
struct MorphometricEnergy {
  double value = 0.0, volume = 0.0, area = 0.0, mean = 0.0, gauss = 0.0, by_probe = 0.0;
};

// Sums the energy over balls, whose lengths in steps are lengths on this lattice.
class MorphometrySum {
 public:
  MorphometrySum(const exact::Lattice &lattice, const AreaWeights &weights, const MorphometricFactors &factors)
      : lattice_(lattice), terms_{weights, factors.tension, factors.pressure}, factors_(factors) {}

  // Returns the derivatives by a ball; its share of the volume is own.measures.measure.volume.
  EnergyGradient add(const BallSet &balls, uint32_t ball, const CurvedBallGradient &own) {
    const MeanCurvatureGradient &curved = own.curvature;
    const double bending[] = {curved.centre.x, curved.centre.y, curved.centre.z};
    EnergyGradient gradient = gradient_of_energy(lattice_, terms_, own.measures);
    sum_.add(share_of_energy(balls, terms_, ball, own.measures, gradient));
    for (int axis = 0; axis < 3; ++axis) gradient.centre[axis] += factors_.bending * bending[axis];
    gradient.radius += factors_.bending * curved.radius;
    gradient.one_sided = gradient.one_sided || curved.one_sided;
    mean_.add(curved.mean);
    by_probe_.add(gradient.radius);
    return gradient;
  }
  // euler: of the boundary.
  MorphometricEnergy total(int64_t euler) const {
    const Energy energy = sum_.total(lattice_, factors_.tension, factors_.pressure);
    MorphometricEnergy result;
    result.volume = energy.volume;
    result.area = energy.area;
    result.mean = lattice_.length(mean_.total());
    result.gauss = gauss_of_thirds(6 * euler);
    result.value = energy.value + factors_.bending * result.mean + factors_.gaussian * result.gauss;
    result.by_probe = by_probe_.total();
    return result;
  }

 private:
  const exact::Lattice &lattice_;
  const EnergyTerms terms_;
  const MorphometricFactors factors_;
  EnergySum sum_;
  TreeSum mean_, by_probe_;
};

// Calls sink(i, gradient) for every ball i of the input, and returns the energy.
template <class Sink>
MorphometricEnergy differentiate_morphometry(const CubeGrid &grid, const Boundary &boundary, const AreaWeights &weights,
                                             const MorphometricFactors &factors, Sink sink) {
  const BallSet &balls = grid.balls();
  MorphometrySum sum(balls.lattice, weights, factors);
  const bool any_tied = has_tied_vertices(boundary);
  visit_in_input_order(grid, boundary, [&](uint32_t i, uint32_t ball) {
    sink(i, sum.add(balls, ball, curved_gradient_of_ball(balls, boundary, weights, ball, any_tied)));
  });
  return sum.total(boundary.euler());
}

}  // namespace hsp
