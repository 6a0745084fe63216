// The smooth surface beside the boundary that it stands on, and triangles.
#pragma once

#include <ostream>

#include "growth.hpp"
#include "measurements.hpp"

namespace report {

void write_smooth_surface(std::ostream &out, const Run &run);

// Of a measurement of the smooth surface: seconds that the surface, its areas and its volume take beyond the boundary,
// and by how much it takes longer with the gradient in place of areas and volume, in per cent.
double seconds_beyond_boundary(const Measurement &m);
double per_cent_for_gradient(const Measurement &m);

}  // namespace report
