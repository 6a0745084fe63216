// Areas of single patches of the smooth surface, and their terms of the volume.
#pragma once

#include "surface/surface_map.hpp"

namespace hsp {

struct PatchMeasure {
  double area = 0.0;    // square steps
  double volume = 0.0;  // term of the divergence theorem about `origin`, cubic steps
  uint32_t origin = 0;  // the ball of lowest rank of the component
};

PatchMeasure measure_patch(const SurfaceMap &map, uint32_t patch);

}  // namespace hsp
