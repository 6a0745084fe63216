// Depth-first traversal of every shell, the paper's scan of the boundary (Section 4.2, Step 3): from the face with the
// highest point across its edges to the neighbouring faces, until the whole shell has been visited.
#pragma once

#include "topology/topology.hpp"

namespace hsp {

// Counts faces, edges and vertices of every shell, traverses each shell from its start_face, and stores the order of
// the visits in Topology::traversal. entered [simple faces]: scratch memory. Returns false if `patience` allows no more
// work, or if a traversal does not visit exactly the simple faces of its shell, which no correct structure allows.
bool traverse_shells(const Boundary &boundary, Topology &topology, Span<uint32_t> entered,
                     Patience patience = Patience());

}  // namespace hsp
