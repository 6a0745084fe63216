// The circles that two vertices are on, and the covered parts of a circle, between its free arcs.
#pragma once

#include "surface/chosen_faces.hpp"

namespace hsp {

// Calls visit(slot, half_edge) for the half-edges that start at vertex v on a circle that vertex w is on, too, with the
// number of their ball in the record of v. Each lies on a different one of the three circles of v.
template <class Visit>
void for_each_common_circle(const Boundary &boundary, uint32_t v, uint32_t w, Visit visit) {
  const VertexRecord &own = boundary.vertex(v), &other = boundary.vertex(w);
  for (uint32_t slot = 0; slot < 3; ++slot) {
    const uint32_t e = boundary.half_edge_at(v, slot);
    if (other.has(own.ball[slot]) && other.has(boundary.half_edge(e).circle)) visit(slot, e);
  }
}

// A half-edge on `ball` starts at a vertex and runs clockwise about its circle's axis. Counter-clockwise from that
// vertex the circle is covered, up to the end of some arc. Returns the vertex at that end, which is never the vertex
// itself. Arcs of the other part of the boundary (chosen_faces.hpp) do not interrupt the gap.
uint32_t vertex_across_gap(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, uint32_t ball,
                           uint32_t half_edge);

}  // namespace hsp
