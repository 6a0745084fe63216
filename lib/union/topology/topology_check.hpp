// The invariants of a topology, checked from its tables alone. A correct build violates none of them for any input.
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

// Where: the id of a quarter-edge, vertex, simple face, shell or component.
using TopologyViolation = Violation<TopologyInvariant>;

// Invariants 1 to 7, in order. marks [edges] is scratch memory. O(size).
TopologyViolation check_topology(const Boundary &boundary, const Topology &topology, Span<uint32_t> marks);

}  // namespace hsp
