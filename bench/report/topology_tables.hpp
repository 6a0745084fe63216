// Step 3 of Section 4.2: time beside Steps 1 and 2, memory, and locating points.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_topology(std::ostream &out, const Run &run);

}  // namespace report
