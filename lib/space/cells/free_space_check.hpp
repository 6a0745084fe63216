// The invariants of cells of free space, checked from their tables and from power cells that are cut once more. A
// correct build violates none of them for any input.
#pragma once

#include "cells/free_space.hpp"
#include "cells/power_cell.hpp"
#include "core/violation.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class FreeSpaceInvariant : uint32_t {
  none = 0,
  records = 1,      // runs come first, then the free parts of each ball in each cube
  neighbours = 2,   // lists ascend, and each two cells see each other or do not
  regions = 3,      // are the connected components, numbered by their first cells
  power_cells = 4,  // are simple polytopes with V - E + F = 2, with as many free parts as there are cells
  facets = 5,       // a cell has neighbours just across what it has facets on
  complement = 6,   // regions are as many as the cells of the complement
};

// Where: the number of a cell or cube.
using FreeSpaceViolation = Violation<FreeSpaceInvariant>;

// Scratch memory of the builder.
struct FreeSpaceScratch {
  PowerCell &cell;
  Span<uint32_t> sets;   // [cells]
  Span<uint8_t> planes;  // [planes of one power cell]
};

// Invariants 1 to 5. About as much work as the build.
FreeSpaceViolation check_free_space(const BallSet &balls, const FreeSpace &space, FreeSpaceScratch scratch);

}  // namespace hsp
