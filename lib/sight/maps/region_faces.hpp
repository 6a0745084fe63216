// Faces of balls and sticks from loops in order, and the invariants of the map that they complete.
#pragma once

#include "maps/body_sight.hpp"
#include "maps/map_check.hpp"
#include "maps/stick_regions.hpp"

namespace hsp {

// Fills faces from loops, components and what follows what. False if a hole lies in no face of its owner.
bool find_faces(StickRegions &regions);

// The invariants of map_check.hpp. scratch [2 edges].
MapViolation check_regions(const StickRegions &regions, Span<uint32_t> scratch);

}  // namespace hsp
