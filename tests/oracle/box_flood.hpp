// In how many directions free space of a periodic box goes on for ever, and its volumes, bounded from both sides by
// cells of a grid: cells that are free as a whole, and cells that are not covered as a whole.
#pragma once

#include <vector>

#include "brute_pores.hpp"

namespace oracle {

struct DirectionBounds {
  uint32_t least = 0, most = 0;
};

// For balls that have grown by `level`: the most directions of any component, by parts^3 cells. Of images those up to
// two boxes away count.
DirectionBounds free_directions(const Balls &balls, const BoxRows &box, double level, int parts);

// Bounds of the volumes of its components, as parts of the box, each in descending order. They are of the same
// components only if there are as many of each.
struct VolumeBounds {
  std::vector<double> least, most;
};
VolumeBounds free_volumes(const Balls &balls, const BoxRows &box, double level, int parts);

}  // namespace oracle
