// The table of goals: the costs that the library aims at, beside those that it has, with a verdict.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "measurements.hpp"
#include "names.hpp"

namespace report {

// This version and version 0.1.0, one after the other in every round.
struct Turns {
  Run now, old;
};

// Each goal is a line: what | kind | version 0.1.0 there | must | goal | figure, and for some kinds | scale. `there` is
// the machine on which the goals were set; a dash stands for a value that was not measured there. Kinds:
//
//   time      a time at most; the limits scale with the time that version 0.1.0 takes here
//   new_time  a time at most, of a task that version 0.1.0 cannot do; the limits scale with the last column
//   share     a share of the last column, a figure of version 0.1.0; of a task that version 0.1.0 cannot do
//   at_most   a figure that is the same on every machine
//   at_least  likewise
//
// Times are of `turns`, or of `run` and not judged if that is null.
void write_goals(std::ostream &out, const std::vector<std::string> &goals, const Run &run, const Turns *turns,
                 const Lists &lists);

}  // namespace report
