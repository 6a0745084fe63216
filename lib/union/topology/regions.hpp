// Nesting: the components of the union, their outer shells and voids, and the regions of the complement.
//
// The highest point of a component is free and belongs to its outer shell; all its other shells enclose voids. Take the
// vertical ray upwards from its highest point. If the ray enters no face, the component lies in the outer region. If
// the first face that it enters belongs to the shell of a void, the component lies in that void. Else the component
// lies in the same region as the component of that face, whose highest point is higher still. This is the case of a
// union in several pieces, which the paper leaves to the reader.
//
// As an example, seen from the side, a hollow component A with a ball B in its hollow, and C beside it:
//       .---------.
//      /  .-----.  \           the ray from the top of B meets A first, at a face of the shell of its void: B lies in
//     |  (   B   )  |    C     that void. The rays from the tops of A and C meet nothing: both lie in the outer region
//      \  '-----'  /
//       '---------'            regions 2: the outer one, the void       shells 4: A's outer one, its void, B, C
#pragma once

#include "boundary/point_location.hpp"
#include "core/patience.hpp"
#include "topology/topology.hpp"

namespace hsp {

// Counts the balls of the components and finds their topmost balls.
void gather_components(const CubeGrid &grid, const Boundary &boundary, Topology &topology);

// Finds for every shell its component, kind, region and start face, and the regions of the components.
bool gather_regions(const CubeGrid &grid, const Boundary &boundary, Patience &patience, Topology &topology);

// Count the balls with a face on a region, and list the caller's indices of these, ascending; ids [that many]. The
// shells have been traversed. They take O(shells) and the time to sort the balls of the region, if no ball has many
// faces.
uint32_t count_balls_of_region(const Boundary &boundary, const Topology &topology, uint32_t region);
void list_balls_of_region(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t region,
                          Span<uint32_t> ids);

// The region of a point that lies in no closed ball: that of the first shell that a vertical ray upwards enters.
uint32_t region_of_point(const CubeGrid &grid, const Boundary &boundary, const Topology &topology,
                         const exact::Vector &point);

}  // namespace hsp
