// In how many directions free space of a periodic box goes on for ever, bounded from both sides by cells of a grid:
// cells that are free as a whole, and cells that are not covered as a whole.
#pragma once

#include "brute_pores.hpp"

namespace oracle {

struct DirectionBounds {
  uint32_t least = 0, most = 0;
};

// For balls that have grown by `level`: the most directions of any component, by parts^3 cells. Of images those up to
// two boxes away count.
DirectionBounds free_directions(const Balls &balls, const BoxRows &box, double level, int parts);

}  // namespace oracle
