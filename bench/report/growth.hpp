// How time and memory grow with the number of balls, over all sets that one kind of benchmark was run for.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measurements.hpp"

namespace report {

// From so many balls on a set counts as large: the branch predictor learns a smaller one by heart when it is repeated.
constexpr double large_set = 4000;

// What is looked at of a measurement: seconds, bytes, a ratio.
using Amount = std::function<double(const Measurement &)>;

// MOLECULE of all benchmarks prefix + MOLECULE, by number of balls; those that failed or were skipped come last.
std::vector<std::string> molecules_by_size(const Run &run, const std::string &prefix);

// The exponent e of amount ~ n^e, by least squares over logarithms, of the sets of at least `from` balls; NaN with
// fewer than three of them.
double growth_exponent(const Run &run, const std::string &prefix, double from, const Amount &amount);

// The largest amount of the sets of at least `from` balls; NaN if there is none.
double largest_amount(const Run &run, const std::string &prefix, double from, const Amount &amount);

// A counter as an amount.
Amount counter_of(const std::string &name);

}  // namespace report
