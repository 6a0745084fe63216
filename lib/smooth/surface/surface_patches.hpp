// Areas of single patches of the smooth surface, and their terms of the volume.
#pragma once

#include "measure/areas.hpp"
#include "surface/surface_map.hpp"

namespace hsp {

// In lattice steps; the volume's term is about the origin of the component, as for a ball.
BallMeasure measure_patch(const SurfaceMap &map, uint32_t patch);

}  // namespace hsp
