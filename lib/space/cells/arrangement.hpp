// The size of the arrangement of the spheres (Theorem 2.2): the numbers of its vertices, edges and faces, covered ones
// too. They are counted sphere by sphere and not stored.
//
// If on one sphere v points are common to two circles, and the union of the circles has k components, there are v + k +
// 1 faces, by Euler's relation. Four arcs end in each point; a circle that crosses no other one is one edge.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

struct Arrangement {
  uint64_t vertices = 0, edges = 0, faces = 0;
};

// Counts the parts of the sphere of ball `i`, in grid order. A neighbour takes two words of scratch memory. words
// becomes the number needed; with less memory nothing is counted.
Arrangement arrangement_on_sphere(const CubeGrid &grid, uint32_t i, Span<uint32_t> scratch, uint64_t &words);

}  // namespace hsp
