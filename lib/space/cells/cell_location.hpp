// The cell of free space that holds a lattice point, decided exactly.
//
// In a cube that balls meet the point x belongs to the power cell K of the ball B of least power. If K has several free
// parts: take the plane through x that is normal to the way from the centre of B to x. The half-space behind it does
// not meet B. So its intersection with K is convex and free, and contains x. It also contains a vertex of K, as a
// linear function has its maximum over K at a vertex. So x is in the cell of any vertex of K in that half-space.
#pragma once

#include "cells/free_space.hpp"

namespace hsp {

// The cell of a point; no_id if the point is in a ball or on its sphere.
uint32_t cell_at(const BallSet &balls, const FreeSpace &space, const exact::Vector &point);

}  // namespace hsp
