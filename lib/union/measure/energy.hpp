// The energy that is linear in area and volume of the union, with its derivatives by centres and radii. Sums run over
// the balls in the caller's order.
//
// As an example two balls of radius 5 whose centres are 8 apart, with a tension of 2 and a pressure of 3. The areas are
// 90 pi each, and the volume is that of two balls less twice a cap of height 1, pi (15 - 1) / 3 each:
//   S = 180 pi      V = 2 * 500 pi / 3 - 2 * 14 pi / 3 = 324 pi      value = 2 S + 3 V = 1332 pi
// gradients.hpp has the derivatives of these balls. With u the unit vector from ball k to ball j:
//   of S by c_k           5 pi (-u) + 5 pi (-u) = -10 pi u, from the areas of k and of j
//   of V by c_k           -9 pi u
//   of the value by c_k   (2 * -10 pi - 3 * 9 pi) u = -47 pi u
//   of the value by R_k   2 (34.25 pi - 6.25 pi) + 3 * 90 pi = 326 pi, as j loses 2 pi R^2 / d = 6.25 pi of its area
#pragma once

#include "core/summation.hpp"
#include "lanes/wide.hpp"
#include "measure/gradients.hpp"
#include "measure/input_order.hpp"
#include "measure/sums_in_parts.hpp"

namespace hsp {

// tension * S + pressure * V, with S the weighted area and V the volume of the union.
struct EnergyTerms {
  AreaWeights weights;
  double tension = 0.0;
  double pressure = 0.0;
};

// The energy, in the caller's unit.
struct Energy {
  double area = 0.0;    // S
  double volume = 0.0;  // V
  double value = 0.0;
  double by_probe = 0.0;  // derivative by all radii at once
};

// Derivatives by one ball's centre and radius.
struct EnergyGradient {
  double centre[3];
  double radius;
  bool one_sided;
  double area;  // of the ball, in lattice steps: few callers want it in their unit
};

// The derivatives of the energy by one ball, in the caller's unit. A step of the lattice may be any power of ten, so
// derivatives of areas and of volumes are converted each on its own.
inline EnergyGradient gradient_of_energy(const exact::Lattice &lattice, const EnergyTerms &terms,
                                         const BallGradient &ball) {
  // Two numbers at a time, as there are many divisions. The two are not neighbours in memory: if two numbers have just
  // been stored one by one, a load of both as one register has to wait.
  using Pair = Wide<double, 2>::Real;
  const auto combined = [&](const Pair &of_area, const Pair &of_volume) {
    return terms.tension * lattice.lengths(of_area) + terms.pressure * lattice.lengths(lattice.lengths(of_volume));
  };
  const Pair xz = combined(Pair{ball.centre.x, ball.centre.z}, Pair{ball.vector_area.x, ball.vector_area.z});
  const Pair yr = combined(Pair{ball.centre.y, ball.radius}, Pair{ball.vector_area.y, ball.measure.area});
  return {{xz[0], yr[0], xz[1]}, yr[1], ball.one_sided, ball.measure.area};
}

// Derivatives of the weighted area and of the volume, each on its own.
struct MeasureGradient {
  double area_centre[3];
  double volume_centre[3];
  double area_radius;
  double volume_radius;
  bool one_sided;
};

// Calls sink(i, gradient) for every ball i of a range of the input.
template <class Sink>
void differentiate_measures(const CubeGrid &grid, const Boundary &boundary, const AreaWeights &weights, IdRange range,
                            Sink sink) {
  const BallSet &balls = grid.balls();
  const EnergyTerms area{weights, 1.0, 0.0};
  const EnergyTerms volume{weights, 0.0, 1.0};
  visit_in_input_order(grid, boundary, range, [&](uint32_t i, uint32_t ball) {
    const BallGradient own = gradient_of_ball(balls, boundary, weights, ball);
    const EnergyGradient of_area = gradient_of_energy(balls.lattice, area, own);
    const EnergyGradient of_volume = gradient_of_energy(balls.lattice, volume, own);
    sink(i, MeasureGradient{{of_area.centre[0], of_area.centre[1], of_area.centre[2]},
                            {of_volume.centre[0], of_volume.centre[1], of_volume.centre[2]},
                            of_area.radius,
                            of_volume.radius,
                            own.one_sided});
  });
}

// The terms of one ball in an energy.
struct EnergyShare {
  double area;      // weighted, in lattice steps
  double volume;    // in lattice steps
  double by_probe;  // in the caller's unit
};

inline EnergyShare share_of_energy(const BallSet &balls, const EnergyTerms &terms, uint32_t ball,
                                   const BallGradient &own, const EnergyGradient &gradient) {
  return {terms.weights.of(balls, ball) * own.measure.area, own.measure.volume, gradient.radius};
}

// From sums of shares over all balls.
inline Energy energy_of(const EnergyShare &sums, const exact::Lattice &lattice, double tension, double pressure) {
  Energy energy;
  energy.area = lattice.area(sums.area);
  energy.volume = lattice.volume(sums.volume);
  energy.value = tension * energy.area + pressure * energy.volume;
  energy.by_probe = sums.by_probe;
  return energy;
}

class EnergySum {
 public:
  using Term = EnergyShare;
  void add(const EnergyShare &share) {
    area_.add(share.area);
    volume_.add(share.volume);
    by_probe_.add(share.by_probe);
  }
  // The same for `times` equal shares, all of whose numbers are zeros.
  void add_zeros(const EnergyShare &share, uint32_t times) {
    area_.add_zeros(share.area, times);
    volume_.add_zeros(share.volume, times);
    by_probe_.add_zeros(share.by_probe, times);
  }
  EnergyShare sums(const EnergyShare &rest) const {
    return {area_.total(rest.area), volume_.total(rest.volume), by_probe_.total(rest.by_probe)};
  }

 private:
  TreeSum area_, volume_, by_probe_;
};

// Calls sink(i, gradient) for every ball i of a range of the input, or sink(run, gradient) for a run of balls that have
// the same gradient, and adds the shares to the sum.
template <class Sink>
void differentiate_balls(const CubeGrid &grid, const Boundary &boundary, const EnergyTerms &terms, IdRange range,
                         EnergySum &sum, Sink sink) {
  const BallSet &balls = grid.balls();
  const EnergyGradient of_none = gradient_of_energy(balls.lattice, terms, {});  // of balls without faces: zeros, signed
  const EnergyShare no_share{0.0, 0.0, of_none.radius};
  const auto differentiate = [&](uint32_t i, uint32_t ball) {
    if (!boundary.is_exposed(ball)) {
      sum.add(no_share);
      sink(i, of_none);
      return;
    }
    const BallGradient own = gradient_of_ball(balls, boundary, terms.weights, ball);
    const EnergyGradient gradient = gradient_of_energy(balls.lattice, terms, own);
    sum.add(share_of_energy(balls, terms, ball, own, gradient));
    sink(i, gradient);
  };
  visit_in_input_order(grid, boundary, range, differentiate, [&](IdRange run) {
    sum.add_zeros(no_share, run.size());
    sink(run, of_none);
  });
}

// The energy from shares: visit(range, sum) adds those of the balls of a range. False if the executor fails.
template <class Visit>
bool sum_energy(const Executor &executor, uint32_t balls, const exact::Lattice &lattice, const EnergyTerms &terms,
                Visit visit, Energy &energy) {
  EnergyShare sums{};
  const bool each = sum_by<EnergySum>(executor, balls, visit, sums);
  energy = energy_of(sums, lattice, terms.tension, terms.pressure);
  return each;
}

// Calls `sink` as differentiate_balls() does for all balls, by the tasks of the executor, and finds the energy. False
// if the executor fails.
template <class Sink>
bool differentiate_energy(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                          const EnergyTerms &terms, Energy &energy, Sink sink) {
  const auto visit = [&](IdRange range, EnergySum &sum) {
    differentiate_balls(grid, boundary, terms, range, sum, sink);
  };
  return sum_energy(executor, grid.balls().n, grid.balls().lattice, terms, visit, energy);
}

}  // namespace hsp
