// Components: the connected parts of the union. Two balls belong together if they meet.
//
// As an example balls 0 to 3 of the grid, of which 0 meets 2 and 1 meets 3: two components. If the caller has given
// ball 3 first, component 0 is that of balls 1 and 3, and its origin is the one of these with the lower rank.
#pragma once

#include "boundary/boundary.hpp"
#include "core/patience.hpp"

namespace hsp {

// On entry arrays.component_origin holds the parents of disjoint sets, in which balls of one component are joined. Puts
// there for each ball the origin of its component, and numbers the components in the order of their first balls in the
// input.
void number_components(const CubeGrid &grid, Patience &patience, BoundaryArrays &arrays);

}  // namespace hsp
