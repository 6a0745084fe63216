// How large the arrangement of the spheres is (Theorem 2.2): its vertices, edges and faces, covered ones too. They are
// counted sphere by sphere and never stored.
//
// On one sphere v common points of two circles and k components of the union of its circles make v + k + 1 faces, by
// Euler's relation; four arcs end in each point, and a circle that crosses no other is one edge.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

struct Arrangement {
  uint64_t vertices = 0, edges = 0, faces = 0;
};

// All parts of the sphere of ball `i` of the grid's order. A neighbour takes two words of scratch memory; `words`
// becomes how many are needed, and with fewer nothing is counted.
Arrangement arrangement_on_sphere(const CubeGrid &grid, uint32_t i, Span<uint32_t> scratch, uint64_t &words);

}  // namespace hsp
