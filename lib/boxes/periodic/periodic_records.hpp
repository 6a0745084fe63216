// Vertices, arcs and circles of a union in a box, each as it is listed, and the shift at which another ball sees it.
//
// A vertex, arc or circle is listed once, with the first of its balls at its place in the box
// (PeriodicUnion::comes_first). From another of its balls at that ball's place it is seen `shift` away.
#pragma once

#include "periodic/periodic_union.hpp"

namespace hsp {

// Record `id` of a list, moved by a shift.
struct MovedRecord {
  uint32_t id;
  BoxShift shift;
};

// The listed record of a vertex of the boundary.
MovedRecord listed_vertex(const PeriodicUnion &periodic, uint32_t vertex);

// The listed arc of a half-edge on a ball of the grid; and the face on its other side, listed with its ball in the box.
MovedRecord listed_arc(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge);
MovedRecord face_across(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge);
// The angle of the arc, computed on the ball of lower rank, so that the order of the balls does not change its bits.
double angle_of_listed_arc(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge);

// The same for a whole circle.
MovedRecord listed_circle(const PeriodicUnion &periodic, ClosedHalfEdge own);
MovedRecord face_across(const PeriodicUnion &periodic, ClosedHalfEdge own);

}  // namespace hsp
