// Vertices, arcs and circles of a union in a box, each as it is listed, and how far from there it is seen elsewhere.
//
// A vertex, arc or circle is listed once, with the first of its balls at its place in the box
// (PeriodicUnion::comes_first). From another ball at its own place it is seen so many boxes away.
#pragma once

#include "periodic/periodic_union.hpp"

namespace hsp {

// Number `id` of a list, moved by so many boxes.
struct MovedRecord {
  uint32_t id;
  BoxShift shift;
};

// A vertex that the boundary has.
MovedRecord listed_vertex(const PeriodicUnion &periodic, uint32_t vertex);

// The arc of a half-edge on a ball of the grid, and the face on its other side, listed with its ball in the box.
MovedRecord listed_arc(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge);
MovedRecord face_across(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge);
// The angle of the arc, from the ball of lower rank, so that the order of the balls has no effect on any bit.
double angle_of_listed_arc(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge);

// The same of a whole circle.
MovedRecord listed_circle(const PeriodicUnion &periodic, ClosedHalfEdge own);
MovedRecord face_across(const PeriodicUnion &periodic, ClosedHalfEdge own);

}  // namespace hsp
