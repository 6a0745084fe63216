// Section 3's alternatives beside the library, and the paper's remarks about them.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_alternatives(std::ostream &out, const Run &run);

}  // namespace report
