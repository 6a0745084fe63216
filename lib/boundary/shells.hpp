// Shells: the connected components of the boundary. Two faces belong together if they share an arc or a free circle.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Numbers the shells in the order of their first face and stores them in the faces. scratch [faces].
void find_shells(const Boundary &boundary, BoundaryArrays &arrays, Span<uint32_t> scratch);

// The same once the faces have been joined.
void number_shells(DisjointSets shells, BoundaryArrays &arrays);

}  // namespace hsp
