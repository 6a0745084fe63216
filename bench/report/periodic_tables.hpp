// Molecules in periodic boxes beside the same balls in free space.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

// Of the times in the box and in free space, by that of the contacts.
double box_ratio_per_contact(const Measurement &m);
void write_periodic(std::ostream &out, const Run &run);

}  // namespace report
