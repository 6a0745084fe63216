// The packing statistics of Section 2: k, rho, and the numbers of overlaps.
//
// As an example the balls of radius 5 at (0,0,0), (6,0,0) and (0,6,0): k = 1, rho = 6/5, and each overlaps the two
// others. The bound of Theorem 2.1 is 216 / 1.2^3 = 125.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

struct PackingStatistics {
  double k = 0.0;              // r_max / r_min, 0 if there is none
  double rho = 0.0;            // min over pairs of |c_i c_j| / max(r_i, r_j), 0 if there is none
  double mean_overlaps = 0.0;  // over the balls, of the number of others with |c_i c_j| < r_i + r_j
  uint32_t max_overlaps = 0;
  bool zero_radius = false;  // a radius is 0, and k has no value
  bool coincident = false;   // two centres are equal, and rho is 0
  bool no_pair = false;      // there is no pair with a ratio, and rho has no value

  // Theorem 2.1: no more than 216 (k/rho)^3 balls can meet one ball; 0 if k or rho has no value or rho is 0.
  double neighbour_bound() const {
    if (zero_radius || coincident || no_pair) return 0.0;
    const double ratio = k / rho;
    return 216 * ratio * ratio * ratio;
  }
};

// Uses the grid's scratch memory.
PackingStatistics packing_statistics(CubeGrid &grid);

}  // namespace hsp
