// Sums of curvatures over all balls, and the morphometric energy: linear in volume, weighted area, weighted mean
// curvature and Gaussian curvature, with its derivatives. Sums run over the balls in the caller's order.
#pragma once

#include "curvature/curvature.hpp"
#include "measure/energy.hpp"

namespace hsp {

struct CurvatureTotals {
  double mean = 0.0;  // in the caller's unit
  double gauss = 0.0;
};

// The Gaussian curvature from its number of thirds of pi.
inline double gauss_of_thirds(int64_t thirds) {
  return static_cast<double>(thirds) * (pi / 3);
}

// Sums curvatures, in the unit of this lattice. Calls sink(i, curvature) for every ball i of the input that is not in
// the halo, in the same unit. Not for all balls if the executor stops.
template <class Sink>
CurvatureTotals sum_curvatures(const CubeGrid &grid, const Boundary &boundary, const exact::Lattice &lattice, Sink sink,
                               const Executor &executor = Executor()) {
  TreeSum mean;
  int64_t thirds = 0;
  const auto visit = [&](uint32_t i, uint32_t ball) {
    BallCurvature curvature = curvature_of_ball(grid.balls(), boundary, ball);
    mean.add(curvature.mean);
    thirds += curvature.gauss;
    curvature.mean = lattice.length(curvature.mean);
    sink(i, curvature);
  };
  visit_patiently(executor, IdRange{0, grid.own_balls()},
                  [&](IdRange part) { visit_in_input_order(grid, boundary, part, visit); });
  return {lattice.length(mean.total()), gauss_of_thirds(thirds)};
}

struct MorphometricFactors {
  double pressure = 0.0, tension = 0.0, bending = 0.0, gaussian = 0.0;
};

// An energy and its parts, in the caller's unit.
struct MorphometricEnergy {
  double value = 0.0, volume = 0.0, area = 0.0, mean = 0.0, gauss = 0.0, by_probe = 0.0;
};

// The terms of one ball in a morphometric energy.
struct MorphometryShare {
  EnergyShare measures;  // its by_probe includes that of the mean curvature
  double mean;           // the mean curvature, in lattice steps
};

class MorphometrySum {
 public:
  using Term = MorphometryShare;
  void add(const MorphometryShare &share) {
    measures_.add(share.measures);
    mean_.add(share.mean);
  }
  MorphometryShare sums(const MorphometryShare &rest) const {
    return {measures_.sums(rest.measures), mean_.total(rest.mean)};
  }

 private:
  EnergySum measures_;
  TreeSum mean_;
};

// The terms of an energy of balls on a lattice.
struct MorphometryTerms {
  const exact::Lattice &lattice;
  AreaWeights weights;
  MorphometricFactors factors;

  // Returns the derivatives by a ball, and adds its share; its volume is own.measures.measure.volume.
  EnergyGradient add(const BallSet &balls, uint32_t ball, const CurvedBallGradient &own, MorphometrySum &sum) const {
    const EnergyTerms terms{weights, factors.tension, factors.pressure};
    const MeanCurvatureGradient &curved = own.curvature;
    const double bending[] = {curved.centre.x, curved.centre.y, curved.centre.z};
    EnergyGradient gradient = gradient_of_energy(lattice, terms, own.measures);
    for (int axis = 0; axis < 3; ++axis) gradient.centre[axis] += factors.bending * bending[axis];
    gradient.radius += factors.bending * curved.radius;
    gradient.one_sided = gradient.one_sided || curved.one_sided;
    sum.add({share_of_energy(balls, terms, ball, own.measures, gradient), curved.mean});
    return gradient;
  }
  // Sums the shares and sets the energy. visit(range, sum) adds the shares of a range of balls. euler: that of the
  // boundary. False if the executor fails.
  template <class Visit>
  bool sum(const Executor &executor, uint32_t count, int64_t euler, Visit visit, MorphometricEnergy &result) const {
    MorphometryShare sums{};
    const bool each = sum_by<MorphometrySum>(executor, count, visit, sums);
    const Energy energy = energy_of(sums.measures, lattice, factors.tension, factors.pressure);
    result.volume = energy.volume;
    result.area = energy.area;
    result.mean = lattice.length(sums.mean);
    result.gauss = gauss_of_thirds(6 * euler);
    result.value = energy.value + factors.bending * result.mean + factors.gaussian * result.gauss;
    result.by_probe = energy.by_probe;
    return each;
  }
};

// Calls sink(i, gradient) for every ball i of the input, from the tasks of the executor. False if that fails.
template <class Sink>
bool differentiate_morphometry(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                               const AreaWeights &weights, const MorphometricFactors &factors,
                               MorphometricEnergy &energy, Sink sink) {
  const BallSet &balls = grid.balls();
  const MorphometryTerms terms{balls.lattice, weights, factors};
  const CurvedSet set = curved_set(balls, boundary);
  const auto visit = [&](IdRange range, MorphometrySum &sum) {
    visit_in_input_order(grid, boundary, range, [&](uint32_t i, uint32_t ball) {
      sink(i, terms.add(balls, ball, curved_gradient_of_ball(balls, boundary, weights, ball, set), sum));
    });
  };
  return terms.sum(executor, balls.n, boundary.euler(), visit, energy);
}

}  // namespace hsp
