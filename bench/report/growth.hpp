// How time and memory grow with the number of balls, over all sets that one kind of benchmark was run for.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "measurements.hpp"

namespace report {

// MOLECULE of all benchmarks prefix + MOLECULE, by number of balls; those that failed or were skipped come last.
std::vector<std::string> molecules_by_size(const Run &run, const std::string &prefix);

// The exponent e of amount ~ n^e, by least squares over the logarithms of pairs of n and an amount; NaN with fewer than
// three pairs.
double growth_exponent(const std::vector<std::pair<double, double>> &amounts);

}  // namespace report
