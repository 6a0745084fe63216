// Areas, volumes and their derivatives beside the boundary they are taken from, and frames of a trajectory.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_gradients(std::ostream &out, const Run &run);

}  // namespace report
