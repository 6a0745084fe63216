// Area and enclosed volume of the shells of a boundary, and of the regions between them.
#pragma once

#include "measure/areas.hpp"
#include "topology/topology_check.hpp"

namespace hsp {

// Area of a shell, and the sum of its faces' terms of the volume. For an outer shell the sum is the volume of the space
// that it encloses; for the shell of a void, minus that volume, as the faces point into the void. Sums run in the order
// of the shell's traversal, which does not depend on ids.
BallMeasure measure_shell(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t shell);

// Fills for each region of the complement its area and volume in the caller's unit, its enclosing shell, the number of
// shells that border on it and the number of components that lie in it. Region 0 is unbounded: its volume is set to 0
// and its enclosing shell is no_id. regions [region_count]. Region has area, volume, enclosing_shell, shells and
// components.
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
    // Outward from the union is into the region, both on its enclosing shell and on shells that lie in it.
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

// Checks invariant 8: the sign of each shell's volume, up to rounding.
TopologyViolation check_enclosed_volumes(const BallSet &balls, const Boundary &boundary, const Topology &topology);

}  // namespace hsp
