// Totals over all balls: area and volume of the union, and the energy that is linear in them with its derivatives. Sums
// run over the balls in the caller's order.
#pragma once

#include "core/ahead.hpp"
#include "core/summation.hpp"
#include "lanes/wide.hpp"
#include "measure/gradients.hpp"
#include "measure/input_order.hpp"
#include "measure/sums_in_parts.hpp"

namespace hsp {

inline BallMeasure in_caller_units(const exact::Lattice &lattice, const BallMeasure &measure) {
  return {lattice.area(measure.area), lattice.volume(measure.volume)};
}

// Sums measures of balls, in lattice steps.
class MeasureSum {
 public:
  using Term = BallMeasure;
  void add(const BallMeasure &measure) {
    area_.add(measure.area);
    volume_.add(measure.volume);
  }
  BallMeasure sums(const BallMeasure &rest) const { return {area_.total(rest.area), volume_.total(rest.volume)}; }
  BallMeasure total() const { return sums({}); }

 private:
  TreeSum area_, volume_;
};

// Makes of all balls' measures, in lattice steps and the caller's order, those in the caller's unit; returns the sums.
inline BallMeasure sum_and_convert(const BallSet &balls, double *area, double *volume) {
  const exact::Lattice &lattice = balls.lattice;
  MeasureSum sum;
  const auto convert = [&]<uint32_t n>(Wide<double, n>, uint32_t i) {
    using L = Wide<double, n>;
    for (uint32_t k = i; k < i + n; ++k) sum.add({area[k], volume[k]});
    L::store(area + i, lattice.lengths(lattice.lengths(L::load(area + i))));
    L::store(volume + i, lattice.lengths(lattice.lengths(lattice.lengths(L::load(volume + i)))));
  };
  // Most of it is divisions.
  constexpr uint32_t lanes = small_code ? 1 : 2;
  uint32_t i = 0;
  for (; i + lanes <= balls.n; i += lanes) convert(Wide<double, lanes>{}, i);
  for (; i < balls.n; ++i) convert(Wide<double, 1>{}, i);
  return in_caller_units(lattice, sum.total());
}

// Whether ball i of the input, with that index in the grid's order, has faces that count. selected may be null; the
// faces of balls i with selected[i] == 0 count as 0.
inline bool has_counted_faces(const Boundary &boundary, const uint8_t *selected, uint32_t i, uint32_t ball) {
  return (selected == nullptr || selected[i] != 0) && boundary.is_exposed(ball);
}

// Its measure in lattice steps; 0 if none of its faces counts.
inline BallMeasure measure_counted(const BallSet &balls, const Boundary &boundary, const uint8_t *selected, uint32_t i,
                                   uint32_t ball) {
  return has_counted_faces(boundary, selected, i, ball) ? measure_ball(balls, boundary, ball) : BallMeasure{};
}

// Calls sink(i, measure) for every ball i of a range of the input, in the caller's unit, and adds to the sum. Nothing
// is 0 in every unit: only balls that have faces need the divisions.
template <class Sink>
void measure_range(const CubeGrid &grid, const Boundary &boundary, const uint8_t *selected, IdRange range,
                   MeasureSum &sum, Sink sink) {
  visit_in_input_order(grid, boundary, range, [&](uint32_t i, uint32_t ball) {
    if (!has_counted_faces(boundary, selected, i, ball)) {
      sum.add({});
      sink(i, BallMeasure{});
      return;
    }
    const BallMeasure measure = measure_ball(grid.balls(), boundary, ball);
    sum.add(measure);
    sink(i, in_caller_units(grid.balls().lattice, measure));
  });
}

// The same for all balls; returns the sums.
template <class Sink>
BallMeasure measure_union(const CubeGrid &grid, const Boundary &boundary, const uint8_t *selected, Sink sink) {
  MeasureSum sum;
  measure_range(grid, boundary, selected, {0, grid.balls().n}, sum, sink);
  return in_caller_units(grid.balls().lattice, sum.total());
}

// The same into arrays in the caller's order, which do not overlap; each may be null. With both of them balls are
// measured in the grid's order, in which what belongs to them follows each other in memory, and summed in the caller's
// afterwards.
inline BallMeasure measure_into(const CubeGrid &grid, const Boundary &boundary, const uint8_t *selected, double *area,
                                double *volume) {
  if (small_code || area == nullptr || volume == nullptr) {
    return measure_union(grid, boundary, selected, [&](uint32_t i, const BallMeasure &measure) {
      if (area != nullptr) area[i] = measure.area;
      if (volume != nullptr) volume[i] = measure.volume;
    });
  }
  const BallSet &balls = grid.balls();
  for (uint32_t ball = 0; ball < balls.n; ++ball) {
    if (ball + ahead::outputs < balls.n) {
      const uint32_t later = balls.caller[ball + ahead::outputs];
      __builtin_prefetch(&area[later], 1);
      __builtin_prefetch(&volume[later], 1);
    }
    const uint32_t i = balls.caller[ball];
    const BallMeasure measure = measure_counted(balls, boundary, selected, i, ball);
    area[i] = measure.area;
    volume[i] = measure.volume;
  }
  return sum_and_convert(balls, area, volume);
}

// The same by several tasks. False if the executor fails.
inline bool measure_in_parts(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                             const uint8_t *selected, double *area, double *volume, BallMeasure &total) {
  const auto put = [area, volume](uint32_t i, const BallMeasure &measure) {
    if (area != nullptr) area[i] = measure.area;
    if (volume != nullptr) volume[i] = measure.volume;
  };
  const auto measure_part = [&](IdRange range, MeasureSum &sum) {
    measure_range(grid, boundary, selected, range, sum, put);
  };
  const bool each = sum_in_parts<MeasureSum>(executor, grid.balls().n, measure_part, total);
  total = in_caller_units(grid.balls().lattice, total);
  return each;
}

// tension * S + pressure * V, with S the weighted area and V the volume of the union.
struct EnergyTerms {
  AreaWeights weights;
  double tension = 0.0;
  double pressure = 0.0;
};

// In the caller's unit.
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
  double area;  // of the ball, in lattice steps: few want it in the caller's unit
};

// One ball's part. A step of the lattice may be any power of ten, so derivatives of an area and of a volume are
// converted each on its own.
inline EnergyGradient gradient_of_energy(const exact::Lattice &lattice, const EnergyTerms &terms,
                                         const BallGradient &ball) {
  // Two numbers at a time, as there are many divisions. No two that are neighbours in memory: a register loaded from
  // where two numbers have just been stored waits for them.
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
  EnergyShare sums(const EnergyShare &rest = {}) const {
    return {area_.total(rest.area), volume_.total(rest.volume), by_probe_.total(rest.by_probe)};
  }
  Energy total(const exact::Lattice &lattice, double tension, double pressure) const {
    return energy_of(sums(), lattice, tension, pressure);
  }

 private:
  TreeSum area_, volume_, by_probe_;
};

// Calls sink(i, gradient, share) for every ball i of a range of the input.
template <class Sink>
void differentiate_balls(const CubeGrid &grid, const Boundary &boundary, const EnergyTerms &terms, IdRange range,
                         Sink sink) {
  const BallSet &balls = grid.balls();
  const EnergyGradient of_none = gradient_of_energy(balls.lattice, terms, {});  // of balls without faces: with signs
  visit_in_input_order(grid, boundary, range, [&](uint32_t i, uint32_t ball) {
    if (!boundary.is_exposed(ball)) {
      sink(i, of_none, EnergyShare{0.0, 0.0, of_none.radius});
      return;
    }
    const BallGradient own = gradient_of_ball(balls, boundary, terms.weights, ball);
    const EnergyGradient gradient = gradient_of_energy(balls.lattice, terms, own);
    sink(i, gradient, share_of_energy(balls, terms, ball, own, gradient));
  });
}

// Calls sink(i, gradient) for every ball i of the input, and returns the energy.
template <class Sink>
Energy differentiate_energy(const CubeGrid &grid, const Boundary &boundary, const EnergyTerms &terms, Sink sink) {
  const BallSet &balls = grid.balls();
  EnergySum sum;
  differentiate_balls(grid, boundary, terms, {0, balls.n},
                      [&](uint32_t i, const EnergyGradient &gradient, const EnergyShare &share) {
                        sum.add(share);
                        sink(i, gradient);
                      });
  return sum.total(balls.lattice, terms.tension, terms.pressure);
}

// The energy of balls whose shares visit(range, sum) adds, with lengths on this lattice. False if the executor fails.
template <class Visit>
bool sum_energy(const Executor &executor, uint32_t balls, const exact::Lattice &lattice, const EnergyTerms &terms,
                Visit visit, Energy &energy) {
  EnergyShare sums{};
  const bool each = sum_by<EnergySum>(executor, balls, visit, sums);
  energy = energy_of(sums, lattice, terms.tension, terms.pressure);
  return each;
}

// Calls sink(i, gradient) for every ball i of the input, from the tasks of the executor. False if that fails.
template <class Sink>
bool differentiate_energy(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                          const EnergyTerms &terms, Energy &energy, Sink sink) {
  const auto visit = [&](IdRange range, EnergySum &sum) {
    differentiate_balls(grid, boundary, terms, range,
                        [&](uint32_t i, const EnergyGradient &gradient, const EnergyShare &share) {
                          sum.add(share);
                          sink(i, gradient);
                        });
  };
  return sum_energy(executor, grid.balls().n, grid.balls().lattice, terms, visit, energy);
}

}  // namespace hsp
