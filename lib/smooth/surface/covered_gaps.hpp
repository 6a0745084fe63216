// The covered parts of a circle, between its free arcs.
#pragma once

#include "surface/chosen_faces.hpp"

namespace hsp {

// A half-edge starts at a vertex and runs clockwise about its circle's axis; counter-clockwise from the vertex the
// circle is covered, up to the end of some arc.
struct CoveredGap {
  uint32_t vertex;     // at the other end; never the vertex itself
  uint32_t half_edge;  // that ends there
};
// Arcs of the other part of the boundary do not interrupt it.
CoveredGap gap_behind(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, uint32_t ball,
                      uint32_t half_edge);

// The angle of the gap, in [0, 2 pi]; from exact integers, which distinguish 0 from 2 pi.
double angle_of_gap(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t half_edge,
                    const CoveredGap &gap);

}  // namespace hsp
