// Area and enclosed volume of the shells of a boundary.
#pragma once

#include "measure/areas.hpp"
#include "topology/topology_check.hpp"

namespace hsp {

// Area of a shell, and its faces' terms of the volume: positive for an outer shell, the space it encloses; negative for
// a void, whose faces look into it. Summed in the order of the shell's scan, which does not depend on ids.
BallMeasure measure_shell(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t shell);

// Law 8: the sign of each shell's volume, up to rounding.
TopologyViolation check_enclosed_volumes(const BallSet &balls, const Boundary &boundary, const Topology &topology);

}  // namespace hsp
