// Positions of the vertices, arcs and circles of a boundary. Each is computed from the ball of lowest rank among its
// own, so that ids have no effect on any bit.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// A point, relative to the centre of a ball, in lattice steps.
struct Position {
  uint32_t ball;
  Vec3 offset;
};

// The point in the caller's coordinates.
void to_coordinates(const BallSet &balls, const Position &position, double xyz[3]);

Position position_of_vertex(const BallSet &balls, const Boundary &boundary, uint32_t vertex);

// The point where a half-edge of a ball starts, relative to the centre of that ball.
Vec3 start_of(const BallSet &balls, const Boundary &boundary, uint32_t ball, const HalfEdge &half_edge);

// The angle of a half-edge's arc, in radians. Twins have the same bits.
double angle_of_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge);

// The circle in which two spheres meet, in lattice steps. The axis is a unit vector from ball a towards ball b.
struct CirclePosition {
  Position centre;
  Vec3 axis;
  double radius;
};
CirclePosition position_of_circle(const BallSet &balls, uint32_t a, uint32_t b);

}  // namespace hsp
