// Shells: the connected components of the boundary. Two faces belong together if they share an arc or a free circle.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Numbers the shells in the order of their first face and stores them in the faces.
void gather_shells(BoundaryStructure &boundary);

}  // namespace hsp
