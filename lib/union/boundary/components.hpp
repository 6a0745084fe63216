// Components: the connected parts of the union. Two balls belong together if they meet.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Names the components, joined in arrays.component_origin as disjoint sets, by their balls of lowest rank, and numbers
// them in the order of their first ball in the input.
void number_components(const CubeGrid &grid, BoundaryArrays &arrays);

}  // namespace hsp
