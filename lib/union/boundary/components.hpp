// Components: the connected parts of the union. Two balls belong together if they meet.
//
// As an example balls 0 to 3 of the grid, of which 0 meets 2 and 1 meets 3: two components. If the caller has given
// ball 3 first, that of 1 and 3 is component 0, and its origin is the ball of lower rank of the two.
#pragma once

#include "boundary/boundary.hpp"
#include "core/patience.hpp"

namespace hsp {

// Names the components, joined in arrays.component_origin as disjoint sets, by their balls of lowest rank, and numbers
// them in the order of their first ball in the input.
void number_components(const CubeGrid &grid, Patience &patience, BoundaryArrays &arrays);

}  // namespace hsp
