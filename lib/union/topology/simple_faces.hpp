// From loops, subdivision vertices and cut arcs to the quad-edge structure with simple faces.
#pragma once

#include "topology/topology.hpp"

namespace hsp {

// The number of edges that the structure will have. Its cut arcs and subdivision vertices are there.
uint64_t count_edges(const BallSet &balls, const Boundary &boundary, const Topology &topology);

// The number of edges without cut arcs: one for each arc, two for each free circle and each whole sphere.
uint64_t count_uncut_edges(const BallSet &balls, const Boundary &boundary);

// Fills quad-edges, vertices and simple faces. There must be room for count_edges() edges. If `patience` allows no more
// work, some are missing.
void assemble_simple_faces(const BallSet &balls, const Boundary &boundary, Patience &patience, Topology &topology);

}  // namespace hsp
