// Lattices of equal balls whose cells are boxes: everything about their unions follows from their cells.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "degenerate_set.hpp"

namespace degenerate {

struct BoxLattice {
  std::array<int64_t, 3> counts;
  std::array<int64_t, 3> sides;  // of a cell; lengths 7 times that if slanted
  int64_t radius;
  bool slanted = false;  // along (2, 3, 6), (3, -6, 2), (6, 2, -3) instead of the axes
};

std::string name_of(const BoxLattice &lattice);

// Ball (i, j, k) is number (i counts[1] + j) counts[2] + k.
oracle::Balls balls_of(const BoxLattice &lattice);

// The union can be shrunk to the edges, rectangles and boxes of the lattice whose half diagonals are at most the
// radius (its alpha complex). Voids are boxes that are missing inside six rectangles that are there.
Topology topology_of(const BoxLattice &lattice);

}  // namespace degenerate
