// Which cell of free space holds a point of the lattice, decided exactly.
//
// In a cube that balls meet the point belongs to the power cell K of the ball B of least power. If that has several
// free parts: the half-space behind the plane through the point that is normal to the way there from the centre of B
// does not meet B, so what K has of it is convex and free, and holds the point. It also holds a vertex of K, as a
// linear function has its maximum over K at one. So the point is in the cell of any vertex of K in that half-space.
#pragma once

#include "cells/free_space.hpp"

namespace hsp {

// no_id if the point is in a ball, or on its sphere.
uint32_t cell_at(const BallSet &balls, const FreeSpace &space, const exact::Vector &point);

}  // namespace hsp
