// Time per atom over size, and how it stands against what was set as a goal.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

// One table per surface: microseconds per atom of each part, from the smallest to the largest molecule, and the
// exponent e of time ~ n^e fitted to the sizes from 4000 on.
void write_scaling(std::ostream &out, const Run &run);

// Nanoseconds per query by kind and molecule.
void write_queries(std::ostream &out, const Run &run);

// The goals, and whether they are met.
void write_goals(std::ostream &out, const Run &run);

}  // namespace report
