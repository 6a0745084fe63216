// Other programs beside the library, in the same run.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_peers(std::ostream &out, const Run &run);

}  // namespace report
