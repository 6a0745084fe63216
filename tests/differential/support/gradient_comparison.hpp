// The library's gradients against difference quotients.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure_differences.hpp"

// The outcome of a number of comparisons. Derivatives of areas are relative to the largest radius, those of volumes to
// its square.
struct GradientTally {
  size_t compared = 0;
  size_t beyond = 0;                // quotients known less well than to the tolerance: compared up to their own bound
  long double worst = 0;            // difference, of the others
  long double worst_of_bounds = 0;  // of all

  void add(const GradientTally &other);
};

inline constexpr long double gradient_tolerance = 1e-8L;

// Compares dA_i/dx for every ball i, dV/dx, and the derivatives of the total area and of a weighted energy, for x the
// four numbers of each of these balls. Empty if all agree.
std::string gradients_differ(const oracle::Balls &balls, const std::vector<size_t> &movers, const Measure &measure,
                             GradientTally &tally);

std::string to_text(const GradientTally &tally);
