// From vertices, each decided once, to loops: every vertex is handed to its three balls, and each use finds the use
// that follows it.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Fills uses, circle sides and loops from vertices and circles.
void assemble_loops(const BallSet &balls, BoundaryStructure &boundary);

// The use on the other ball that walks the same arc the other way: it starts where this one ends.
inline uint32_t twin_use(const BoundaryStructure &boundary, uint32_t use) {
  const VertexUse &walk = boundary.uses[use];
  const uint32_t end = boundary.uses[walk.next].vertex;
  const VertexRecord &vertex = boundary.vertices[end];
  const uint32_t t = vertex.ball[0] == walk.out ? 0 : vertex.ball[1] == walk.out ? 1 : 2;
  return boundary.use_at[3 * end + t];
}

}  // namespace hsp
