// Positions of the vertices and edges of a topology. Each is computed from the ball of lowest rank among its own, so
// that ids have no effect on any bit.
#pragma once

#include "measure/boundary_positions.hpp"
#include "topology/topology.hpp"

namespace hsp {

// The position of a vertex of the topology.
Position position_of_point(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t vertex);

// The circle of an edge e, and the angle of the edge. Quarter-edge 4 e runs counter-clockwise about the axis.
struct EdgeGeometry {
  Position centre;
  Vec3 axis;
  double radius;
  double angle;
};
EdgeGeometry geometry_of_edge(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t edge);

}  // namespace hsp
