// What the library is meant to cost, beside what it does.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

// This version and version 0.1.0, one after the other in every round.
struct Turns {
  Run now, old;
};

// Times and the limits for them are of `turns`, or of `run` and not judged if that is null. Limits scale with version
// 0.1.0: they were set on another machine, where it took the times that stand in speed_goals.cpp.
void write_speed_goals(std::ostream &out, const Run &run, const Turns *turns);

// Exponents e of time or memory ~ n^e, for each stage.
void write_exponents(std::ostream &out, const Run &run);

}  // namespace report
