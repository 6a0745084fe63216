// Invariants of every union in a periodic box. Each compares two computations that have little in common.
#pragma once

#include "core/violation.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

enum class PeriodicInvariant : uint32_t {
  none = 0,
  records,  // a contact across a face of the box is there from both sides, with the same flags
  closure,  // faces and contacts of each ball close its share: their vector areas sum to 0
  outside,  // the vector areas of all faces sum to 0
  volume,   // the shares sum to the volume that faces, and contacts across the faces of the box, give
};

// `where` is the caller's number of a ball.
using PeriodicViolation = Violation<PeriodicInvariant>;

PeriodicViolation check_periodic(const PeriodicUnion &periodic);

}  // namespace hsp
