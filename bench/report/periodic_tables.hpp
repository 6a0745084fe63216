// Molecules in periodic boxes beside the same balls in free space.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_periodic(std::ostream &out, const Run &run);

}  // namespace report
