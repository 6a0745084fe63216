// The paper's scan of the boundary (Section 4.2, Step 3): from the face with the highest point over its edges to the
// faces on their other sides, and on from each of them, until a whole shell has been visited.
#pragma once

#include "topology/topology.hpp"

namespace hsp {

// Tallies faces, edges and vertices of every shell, scans each from its start_face, and stores the order of the visits.
// entered [simple faces] is scratch memory. Returns false if a scan does not visit its shell and nothing else, which no
// correct structure allows.
bool traverse_shells(const Boundary &boundary, Topology &topology, Span<uint32_t> entered);

}  // namespace hsp
