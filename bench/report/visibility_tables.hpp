// Section 5.2: the visibility map beside the analytic z-buffer, and CGAL's envelope of spheres.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_visibility(std::ostream &out, const Run &run);

}  // namespace report
