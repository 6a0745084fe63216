// The laws of a boundary's structure, checked from its records alone. A correct build violates none of them for any
// input; they are there for fuzzers, for careful callers, and for whoever changes the code.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class BoundaryLaw : uint32_t {
  none = 0,
  vertices = 1,
  uses = 2,
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

// The first law that does not hold, and the id of the vertex, use, loop, face, shell or ball where it fails; no_id
// where none does.
struct Violation {
  BoundaryLaw law = BoundaryLaw::none;
  uint32_t where = no_id;
};

// Laws 1 to 8, in order. O(size); overwrites the boundary's scratch face_parent, which nothing reads once shells are
// known.
Violation check_structure(const BallSet &balls, const BoundaryStructure &boundary);

}  // namespace hsp
