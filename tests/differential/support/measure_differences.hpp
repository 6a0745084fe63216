// Derivatives of areas and volume by moving and growing one ball, with bounds on their errors. The areas and volumes
// come from slices or from the library. Which steps can be used is decided by the library's boundary in either case.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "difference_quotients.hpp"
#include "lattice_ball.hpp"

// Free areas of the balls and terms that sum to the volume, in lattice steps, each with a bound of its rounding error.
struct MeasuredValues {
  struct Value {
    long double value = 0;
    long double noise = 0;
  };
  std::vector<Value> area;
  std::vector<Value> volume;
};

using Measure = std::function<MeasuredValues(const oracle::Balls &)>;

MeasuredValues measured_by_library(const oracle::Balls &balls);
MeasuredValues measured_by_slices(const oracle::Balls &balls);

// One of the numbers of a ball: 0, 1, 2 are its centre's coordinates, 3 its radius. With all_balls in place of a ball
// this number of all balls changes at once, which for number 3 is a change of the probe.
struct Variable {
  static constexpr size_t all_balls = static_cast<size_t>(-1);
  static constexpr size_t radius = 3;

  size_t ball = 0;
  size_t number = 0;
};

struct MeasureDerivatives {
  std::vector<DifferenceQuotient> area;
  DifferenceQuotient volume;
};

// By central differences over steps that are powers of two and at most an eighth of the ball's radius (so that moved
// balls are still exact on the lattice). A step is not used if the library's boundary of the moved balls has other
// vertices or circles than that of the balls as given. Of the other steps each quantity takes the four consecutive ones
// on which its error bound is least. Steps get shorter until all bounds are below accuracy * r_max for areas and
// accuracy * r_max^2 for the volume, or rounding takes over. A quantity without four such steps has an infinite error
// bound.
MeasureDerivatives derivatives_by_differences(const oracle::Balls &balls, Variable variable, const Measure &measure,
                                              long double accuracy);

long double largest_radius(const oracle::Balls &balls);
