// The limits of cells, which several kinds of limits have among theirs, by the same names.
#pragma once

#include "cells/free_space.hpp"
#include "hardsphere.h"

namespace hsp::capi {

// HSP_E_RANGE if one is larger than any count.
template <class Limits>
int32_t get_cells_limits(const Limits &limits, FreeSpaceLimits &result) {
  if (limits.cubes > HSP_MAX_BALLS || limits.entries > HSP_MAX_BALLS || limits.cells > HSP_MAX_BALLS ||
      limits.adjacencies > HSP_MAX_BALLS || limits.landmarks > HSP_MAX_BALLS || limits.facets > HSP_MAX_BALLS ||
      limits.corners > HSP_MAX_BALLS || limits.cube_balls > HSP_MAX_BALLS || limits.cube_corners > HSP_MAX_BALLS)
    return HSP_E_RANGE;
  result = {limits.cubes,  limits.entries, limits.cells,      limits.adjacencies, limits.landmarks,
            limits.facets, limits.corners, limits.cube_balls, limits.cube_corners};
  return HSP_OK;
}

template <class Limits>
void put_cells_limits(const FreeSpaceLimits &limits, Limits &result) {
  result.struct_size = sizeof(Limits);
  result.cubes = limits.cubes;
  result.entries = limits.entries;
  result.cells = limits.cells;
  result.adjacencies = limits.adjacencies;
  result.landmarks = limits.landmarks;
  result.facets = limits.facets;
  result.corners = limits.corners;
  result.cube_balls = limits.cube_balls;
  result.cube_corners = limits.cube_corners;
}

}  // namespace hsp::capi
