// The invariants of the cells of free space, checked from their tables and from power cells that are cut once more. A
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
  neighbours = 2,   // lists ascend, and adjacency is mutual
  regions = 3,      // they are the connected components, numbered in the order of their first cells
  power_cells = 4,  // they are simple polytopes with V - E + F = 2, with as many free parts as there are cells
  facets = 5,       // a cell has neighbours exactly across the planes on which it has facets
  complement = 6,   // there are as many regions as cells of the complement
};

// `where` is the number of a cell or cube.
using FreeSpaceViolation = Violation<FreeSpaceInvariant>;

// Scratch memory of the builder.
struct FreeSpaceScratch {
  PowerCell &cell;
  Span<uint32_t> sets;   // [cells]
  Span<uint8_t> planes;  // [planes of one power cell]
};

// Checks invariants 1 to 5. About as much work as the build.
FreeSpaceViolation check_free_space(const BallSet &balls, const FreeSpace &space, FreeSpaceScratch scratch);

}  // namespace hsp
