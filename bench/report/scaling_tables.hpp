// Time per atom over size, and time per query.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

// One table per surface: microseconds per atom of each part, from the smallest to the largest molecule, and the
// exponent e of time ~ n^e fitted to the sizes from 4000 on.
void write_scaling(std::ostream &out, const Run &run);

// Nanoseconds per query by kind and molecule.
void write_queries(std::ostream &out, const Run &run);
void write_split_work(std::ostream &out, const Run &run);

}  // namespace report
