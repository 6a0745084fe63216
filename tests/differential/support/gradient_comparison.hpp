// The library's gradients against difference quotients of areas and volumes, which `Measure` takes from slices (an
// independent oracle) or from the library's own measures (a check of consistency).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure_differences.hpp"

// The outcome of a number of comparisons. Derivatives of areas are relative to the largest radius, those of volumes to
// its square.
struct GradientTally {
  size_t compared = 0;
  size_t beyond = 0;                // quotients whose error bound exceeds the tolerance, and is used in its place
  long double worst = 0;            // largest difference of all other quotients
  long double worst_of_bounds = 0;  // largest error bound of all quotients; infinite if no step could be used

  void add(const GradientTally &other);
};

inline constexpr long double gradient_tolerance = 1e-8L;

// Compares dA_i/dx for every ball i, dV/dx, and the derivatives of the total area and of a weighted energy, where x
// runs through the four numbers of each ball of `movers`. Empty if all agree. A quotient that is not known, with an
// infinite bound, agrees with everything: callers must ask for nearly_all_known.
std::string gradients_differ(const oracle::Balls &balls, const std::vector<size_t> &movers, const Measure &measure,
                             GradientTally &tally);

// Near an arc that is about to be born or to die a quotient is known less well than to the tolerance. That must stay
// rare, and all of them must be known to four digits, or nothing is compared.
bool nearly_all_known(const GradientTally &tally);

std::string to_text(const GradientTally &tally);
