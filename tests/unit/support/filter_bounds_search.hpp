// A search for the input on which a computed number is worst: random starts, then small changes that are kept as long
// as they make it worse.
#pragma once

#include "four_balls.hpp"
#include "perturbation_determinants.hpp"
#include "sweep_length.hpp"

namespace filter_bounds {

// The four balls in the form that the naive determinants take (perturbation_determinants.hpp).
perturbation::Balls as_given(const FourBalls &four);

// Balls near the limits of the contract: at random, with caps from tiny to nearly whole spheres; with radii as
// different as 1 and 2^29; with nearly parallel axes; with circles that nearly touch.
enum class Kind { any, unlike_radii, parallel_axes, touching_circles };
constexpr int kinds = 4;

FourBalls random_balls(oracle::RandomSource &random, Kind kind);

// A change of one to three numbers, each by anything from one step to its own size.
FourBalls changed(oracle::RandomSource &random, const FourBalls &four);

// The largest value of badness(four) that was found. A negative value means that the input does not count. The long
// form of tests has four times as many starts.
template <class Badness>
double worst(oracle::RandomSource &random, int starts, int changes, const Badness &badness) {
  double largest = 0.0;
  for (int start = 0; start < oracle::numbers(starts); ++start) {
    FourBalls four = random_balls(random, static_cast<Kind>(start % kinds));
    double current = badness(four);
    for (int k = 0; k < changes; ++k) {
      const FourBalls next = changed(random, four);
      if (!next.valid(1)) continue;
      const double value = badness(next);
      if (value >= current) {
        four = next;
        current = value;
      }
    }
    if (current > largest) largest = current;
  }
  return largest;
}

}  // namespace filter_bounds
