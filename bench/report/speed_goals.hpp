// What the library is meant to cost, beside what it does.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

// `old`: version 0.1.0 measured in the same run, or null. Limits that are times scale with it: they were set on another
// machine, where that version took the times that stand in speed_goals.cpp.
void write_speed_goals(std::ostream &out, const Run &run, const Run *old);

// Exponents e of time or memory ~ n^e, for each stage.
void write_exponents(std::ostream &out, const Run &run);

}  // namespace report
