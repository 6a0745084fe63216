// From loops, split points and extra arcs to the quad-edge structure with simple faces.
#pragma once

#include "topology/topology.hpp"

namespace hsp {

// Edges that the structure will have, from its extra arcs and split points.
uint64_t count_edges(const BallSet &balls, const BoundaryStructure &boundary, const TopologyStructure &topology);

// Edges without any extra arc: each arc, two for each free circle and each whole sphere.
uint64_t count_uncut_edges(const BallSet &balls, const BoundaryStructure &boundary);

// Fills quad-edges, vertices and simple faces. There must be room for count_edges.
void assemble_simple_faces(const BallSet &balls, const BoundaryStructure &boundary, TopologyStructure &topology);

// Whether the whole sphere of ball i is a face.
inline bool is_whole_sphere(const BoundaryStructure &boundary, uint32_t i) {
  return boundary.first_face[i + 1] > boundary.first_face[i] && boundary.first_loop[i + 1] == boundary.first_loop[i];
}

}  // namespace hsp
