// Depth-first traversal of every shell, the paper's scan of the boundary (Section 4.2, Step 3): from the face with the
// highest point across its edges to the neighbouring faces, until the whole shell has been visited.
#pragma once

#include "topology/topology.hpp"

namespace hsp {

// Counts faces, edges and vertices of every shell, traverses each from its start_face, and stores the order of the
// visits. entered [simple faces] is scratch memory. Returns false if a traversal does not visit exactly its shell,
// which no correct structure allows.
bool traverse_shells(const Boundary &boundary, Topology &topology, Span<uint32_t> entered,
                     Patience patience = Patience());

}  // namespace hsp
