// Contacts with cells, and curvature with its gradient, beside the boundary they are taken from.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_contacts(std::ostream &out, const Run &run);

}  // namespace report
