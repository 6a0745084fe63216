// Nesting: the components of the union, their outer shells and voids, and the cells of the complement.
//
// The highest point of a component is free and belongs to its outer shell; all its other shells enclose voids. A
// component lies in the cell that the vertical ray from its highest point meets first: in a void, if the face it enters
// belongs to the shell of a void, else in the cell of the component it enters, whose highest point is higher still.
// This is the case of a union in several pieces, which the paper leaves to the reader.
#pragma once

#include "boundary/point_location.hpp"
#include "topology/topology.hpp"

namespace hsp {

// Counts the balls of the components and finds their topmost balls.
void gather_components(const CubeGrid &grid, const Boundary &boundary, Topology &topology);

// Finds for every shell its component, kind, cell and start face, and the cells of the components.
void gather_cells(const CubeGrid &grid, const Boundary &boundary, Topology &topology);

// How many balls have a face on a cell; and the caller's indices of these, [that many], ascending. The shells have been
// traversed. O(shells) and sorting what is on the cell, if no ball has many faces.
uint32_t count_balls_of_cell(const Boundary &boundary, const Topology &topology, uint32_t cell);
void list_balls_of_cell(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t cell,
                        Span<uint32_t> ids);

// The cell of a point in no closed ball: that of the first shell a vertical ray from it enters.
uint32_t cell_of_point(const CubeGrid &grid, const Boundary &boundary, const Topology &topology,
                       const exact::Vector &point);

}  // namespace hsp
