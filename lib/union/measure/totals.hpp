// Totals over all balls: area and volume of the union. Sums run over the balls in the caller's order.
#pragma once

#include "core/ahead.hpp"
#include "core/summation.hpp"
#include "lanes/wide.hpp"
#include "measure/areas.hpp"
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
  [[gnu::noinline]] void add(const BallMeasure &measure) {
    area_.add(measure.area);
    volume_.add(measure.volume);
  }
  // Adds the measures of n balls.
  void add(const double *area, const double *volume, uint32_t n) {
    area_.add(area, n);
    volume_.add(volume, n);
  }
  BallMeasure sums(const BallMeasure &rest) const { return {area_.total(rest.area), volume_.total(rest.volume)}; }
  BallMeasure total() const { return sums({}); }

 private:
  TreeSum area_, volume_;
};

// Sums the measures of all balls, which are in lattice steps and in the caller's order, and converts them in place to
// the caller's unit. Returns the sums in the caller's unit.
inline BallMeasure sum_and_convert(const BallSet &balls, double *area, double *volume) {
  const exact::Lattice &lattice = balls.lattice;
  MeasureSum sum;
  sum.add(area, volume, balls.n);
  const auto convert = [&]<uint32_t n>(Wide<double, n>, uint32_t i) {
    using L = Wide<double, n>;
    L::store(area + i, lattice.lengths(lattice.lengths(L::load(area + i))));
    L::store(volume + i, lattice.lengths(lattice.lengths(lattice.lengths(L::load(volume + i)))));
  };
  // Most of the work is divisions.
  constexpr uint32_t lanes = small_code ? 1 : 2;
  uint32_t i = 0;
  for (; i + lanes <= balls.n; i += lanes) convert(Wide<double, lanes>{}, i);
  for (; i < balls.n; ++i) convert(Wide<double, 1>{}, i);
  return in_caller_units(lattice, sum.total());
}

// Whether ball i of the input, which is `ball` in grid order, has faces that are counted. selected: null, or 0 for each
// ball of the input whose faces are not counted.
inline bool has_counted_faces(const Boundary &boundary, const uint8_t *selected, uint32_t i, uint32_t ball) {
  return (selected == nullptr || selected[i] != 0) && boundary.is_exposed(ball);
}

// The measure of such a ball in lattice steps; 0 if its faces are not counted.
inline BallMeasure measure_counted(const BallSet &balls, const Boundary &boundary, const uint8_t *selected, uint32_t i,
                                   uint32_t ball) {
  return has_counted_faces(boundary, selected, i, ball) ? measure_ball(balls, boundary, ball) : BallMeasure{};
}

// Calls sink(i, measure) for every ball i of a range of the input, with the measure in the caller's unit, and adds it
// to the sum in lattice steps. Only balls with faces need the divisions, as 0 is 0 in every unit.
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

// The same into arrays in the caller's order, which do not overlap; each may be null. If both are given, balls are
// measured in grid order, in which their records follow each other in memory, and summed in the caller's order
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

}  // namespace hsp
