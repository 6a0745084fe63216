// The free space of a periodic box, bounded from both sides by the cells of a grid over the box: in how many directions
// it goes on for ever, and the volumes of its components. Cells that are free as a whole give the lower bounds, cells
// that are not covered as a whole the upper ones. Distances and a flood fill are all that is used.
#pragma once

#include <vector>

#include "brute_pores.hpp"

namespace oracle {

struct DirectionBounds {
  uint32_t least = 0, most = 0;
};

// The largest number of independent directions (0 to 3) in which any component of the free space goes on for ever, for
// balls whose radii have grown by `level`. The grid has parts^3 cells. Images up to two boxes away are looked at.
DirectionBounds free_directions(const Balls &balls, const BoxRows &box, double level, int parts);

// Bounds of the volumes of the components, as parts of the box's volume, each list in descending order. The lists speak
// of the same components only if they are equally long.
struct VolumeBounds {
  std::vector<double> least, most;
};
VolumeBounds free_volumes(const Balls &balls, const BoxRows &box, double level, int parts);

}  // namespace oracle
