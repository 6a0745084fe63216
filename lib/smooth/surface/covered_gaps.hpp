// The covered parts of a circle, between its free arcs.
#pragma once

#include "surface/chosen_faces.hpp"

namespace hsp {

// A half-edge starts at a vertex and runs clockwise about its circle's axis; counter-clockwise from the vertex the
// circle is covered, up to the end of some arc: the vertex there, never the same one. Arcs of the other part of the
// boundary do not interrupt the gap.
uint32_t vertex_across_gap(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, uint32_t ball,
                           uint32_t half_edge);

}  // namespace hsp
