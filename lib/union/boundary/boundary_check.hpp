// Checks the combinatorial invariants of a boundary from its records alone. A correct build violates none of them for
// any input; the check serves fuzzers, careful callers, and those who change the code.
#pragma once

#include "boundary/boundary.hpp"
#include "core/violation.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class BoundaryInvariant : uint32_t {
  none = 0,
  vertices = 1,
  half_edges = 2,
  successors = 3,
  twins = 4,
  loops = 5,
  faces = 6,
  shells = 7,
  euler = 8,
  positions = 9,
  areas = 10,
  closure = 11,
};

// The invariant, and the id of the vertex, half-edge, loop, face, shell or ball that violates it.
using BoundaryViolation = Violation<BoundaryInvariant>;

// Checks invariants 1 to 8, in order. scratch [loops + balls]. O(size).
BoundaryViolation check_boundary(const BallSet &balls, const Boundary &boundary, Span<uint32_t> scratch);

}  // namespace hsp
