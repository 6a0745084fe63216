// The packing statistics of Section 2: k, rho, and the numbers of overlaps.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

struct PackingStatistics {
  double k = 0.0;              // r_max / r_min, 0 if there is none
  double rho = 0.0;            // min over pairs of |c_i c_j| / max(r_i, r_j), 0 if there is none
  double mean_overlaps = 0.0;  // over the balls, of the number of others with |c_i c_j| < r_i + r_j
  uint32_t max_overlaps = 0;
  bool zero_radius = false;  // k has no value
  bool coincident = false;   // rho is 0
  bool no_pair = false;      // rho has no value
};

// Uses the grid's scratch memory.
PackingStatistics packing_statistics(CubeGrid &grid);

}  // namespace hsp
