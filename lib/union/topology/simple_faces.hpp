// From loops, subdivision vertices and cut arcs to the quad-edge structure with simple faces.
#pragma once

#include "topology/topology.hpp"

namespace hsp {

// Edges that the structure will have, from its cut arcs and subdivision vertices.
uint64_t count_edges(const BallSet &balls, const Boundary &boundary, const Topology &topology);

// Edges without any cut arc: each arc, two for each free circle and each whole sphere.
uint64_t count_uncut_edges(const BallSet &balls, const Boundary &boundary);

// Fills quad-edges, vertices and simple faces. There must be room for count_edges. Not all of them if that is stopped.
void assemble_simple_faces(const BallSet &balls, const Boundary &boundary, Patience &patience, Topology &topology);

}  // namespace hsp
