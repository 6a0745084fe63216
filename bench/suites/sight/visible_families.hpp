// Sets whose visibility maps are large, or hard to find: the time of a map depends on more than the number of balls.
#pragma once

#include <cstdint>

#include "paper_molecules.hpp"

namespace bench {

// Balls spread evenly over a cube, about as dense as the atoms of proteins, radii from 1 to 2.
Balls random_balls(uint32_t count);

// Two layers of rows of balls, one before the other along the z axis, that cross each other: the farther one is seen
// through the gaps of the nearer one, so that there are several edges for each ball. 2 rows^2 balls.
Balls crossing_rows(uint32_t rows);

// Balls one before the other along the z axis, each smaller than the one behind it, not quite concentric: every
// silhouette is seen, and every ball is near every disc.
Balls deep_stack(uint32_t count);

}  // namespace bench
