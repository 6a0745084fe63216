// Nesting: the components of the union, their outer shells and voids, and the regions of the complement.
//
// The highest point of a component is free and belongs to its outer shell; all its other shells enclose voids. A
// component lies in the region that the vertical ray from its highest point meets first: in a void, if the face it
// enters belongs to the shell of a void, else in the region of the component it enters, whose highest point is higher
// still. This is the case of a union in several pieces, which the paper leaves to the reader.
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

// How many balls have a face on a region; and the caller's indices of these, [that many], ascending. The shells have
// been traversed. O(shells) and sorting what is on the region, if no ball has many faces.
uint32_t count_balls_of_region(const Boundary &boundary, const Topology &topology, uint32_t region);
void list_balls_of_region(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t region,
                          Span<uint32_t> ids);

// The region of a point in no closed ball: that of the first shell a vertical ray from it enters.
uint32_t region_of_point(const CubeGrid &grid, const Boundary &boundary, const Topology &topology,
                         const exact::Vector &point);

}  // namespace hsp
