// The kernels of critical_points.
#include "pores/cube_halves.hpp"

namespace hsp::HSP_TARGET {

void find_nearest(const NearArrays &near, CubeParts &parts) {
  find_nearest_in_lanes<register_lanes>(near, parts);
}

void find_near(const NearArrays &near, const CubeParts &parts, uint8_t *in) {
  find_near_in_lanes<register_lanes>(near, parts, in);
}

void see(const NearArrays &near, const double *at, ViewedBalls &seen) {
  see_in_lanes<register_lanes>(near, at, seen);
}

uint64_t find_farther(ViewedBalls &seen, uint32_t count) {
  return find_farther_in_lanes<register_lanes>(seen, count);
}

}  // namespace hsp::HSP_TARGET
