// Atoms that move: times of moves beside those of computing all anew.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_updates(std::ostream &out, const Run &run);

}  // namespace report
