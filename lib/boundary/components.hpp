// Components: the connected parts of the union. Two balls belong together if they meet.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Numbers the components, joined in arrays.components, in the order of their first ball in the input.
void number_components(const CubeGrid &grid, BoundaryArrays &arrays);

}  // namespace hsp
