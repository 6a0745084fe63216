// Molecule against molecule: times of poses, beside the paper's and those of other programs.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_poses(std::ostream &out, const Run &run);

}  // namespace report
