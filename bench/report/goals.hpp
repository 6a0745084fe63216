// The costs that the library aims at, beside those that it has.
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

// Each goal is: what | kind | version 0.1.0 there | must | goal | figure, and for some | what it scales with. `there`
// is the machine on which the goals were set; a dash stands for what was not measured there. Kinds:
//
//   time      at most; scales with what version 0.1.0 takes here
//   new_time  the same of what that version cannot do: scales with the last column
//   share     of the last column, of version 0.1.0; of what that version cannot do
//   at_most   a figure that is the same on every machine
//   at_least  likewise
//
// Times are of `turns`, or of `run` and not judged if that is null.
void write_goals(std::ostream &out, const std::vector<std::string> &goals, const Run &run, const Turns *turns,
                 const Lists &lists);

}  // namespace report
