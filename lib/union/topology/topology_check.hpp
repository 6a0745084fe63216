// Checks the invariants of a topology from its tables alone. A correct build violates none of them for any input.
#pragma once

#include "core/violation.hpp"
#include "topology/topology.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class TopologyInvariant : uint32_t {
  none = 0,
  algebra = 1,
  vertices = 2,
  faces = 3,
  sides = 4,
  euler = 5,
  traversal = 6,
  regions = 7,
  volumes = 8,
};

// The invariant, and the id of the quarter-edge, vertex, simple face, shell or component that violates it.
using TopologyViolation = Violation<TopologyInvariant>;

// Checks invariants 1 to 7, in order. marks [edges]: scratch memory. O(size).
TopologyViolation check_topology(const Boundary &boundary, const Topology &topology, Span<uint32_t> marks);

}  // namespace hsp
