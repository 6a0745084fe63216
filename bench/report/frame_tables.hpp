// Section 5.1: frames of hidden surface removal beside the paper's and beside z-buffers.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_frames(std::ostream &out, const Run &run);

}  // namespace report
