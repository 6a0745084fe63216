// What is seen of balls and sticks as paths to be painted: all loops of a body are one, and no two paths overlap.
#pragma once

#include "maps/stick_regions.hpp"
#include "view/painted_paths.hpp"

namespace hsp {

// A directed edge as an arc of the view plane, from vertex to vertex.
ProjectedArc arc_of(const StickRegions &regions, uint32_t half_edge);

// Each edge is drawn once: a contour by its body, a crease or half circle by the nearer body. The regions have to
// outlive them.
PaintedPaths paths_of(const StickRegions &regions);

}  // namespace hsp
