// Area and enclosed volume of the shells of a boundary, and of the regions between them.
#pragma once

#include "measure/areas.hpp"
#include "topology/topology_check.hpp"

namespace hsp {

// Area of a shell, and its faces' terms of the volume: positive for an outer shell, the space it encloses; negative for
// a void, whose faces look into it. Summed in the order of the shell's scan, which does not depend on ids.
BallMeasure measure_shell(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t shell);

// Fills for each region of the complement its area, its volume, its enclosing shell and the numbers of shells and
// components that border on it and lie in it, in the caller's unit. Region 0 has no end: its volume is 0 and its
// enclosing shell no_id. regions [region_count]. Region has area, volume, enclosing_shell, shells and components.
template <class Region>
void measure_regions(const BallSet &balls, const Boundary &boundary, const Topology &topology, Span<Region> regions) {
  for (Region &region : regions) {
    region = {};
    region.enclosing_shell = no_id;
  }
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    const ShellRecord &shell = topology.shells[s];
    Region &region = regions[shell.region];
    ++region.shells;
    if (shell.is_void) region.enclosing_shell = s;
    // Outward from the union is into the region, for its enclosing shell and for what lies in it alike.
    const BallMeasure measure = measure_shell(balls, boundary, topology, s);
    region.area += measure.area;
    region.volume -= measure.volume;
  }
  for (uint32_t c = 0; c < topology.component_count; ++c) ++regions[topology.components[c].region].components;
  regions[0].volume = 0.0;
  for (Region &region : regions) {
    region.area = balls.lattice.area(region.area);
    region.volume = balls.lattice.volume(region.volume);
  }
}

// Invariant 8: the sign of each shell's volume, up to rounding.
TopologyViolation check_enclosed_volumes(const BallSet &balls, const Boundary &boundary, const Topology &topology);

}  // namespace hsp
