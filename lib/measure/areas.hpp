// Areas and volume of the union: Gauss-Bonnet on each sphere, and the divergence theorem over all of them.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// One ball's part, in lattice steps.
struct BallMeasure {
  double area = 0.0;    // of its free faces
  double volume = 0.0;  // its term of the volume
};

// Ball i of the grid's order. Sums run in the order of its uses and circles, which does not depend on ids.
BallMeasure measure_ball(const BallSet &balls, const BoundaryStructure &boundary, uint32_t i);

// The same for one face alone: its area, and its term of the volume about the same origin.
BallMeasure measure_face(const BallSet &balls, const BoundaryStructure &boundary, uint32_t face);

// Calls sink(face, measure) for every face of ball i, ascending.
template <class Sink>
void measure_faces(const BallSet &balls, const BoundaryStructure &boundary, uint32_t i, Sink sink) {
  for (uint32_t face = boundary.first_face[i]; face < boundary.first_face[i + 1]; ++face) {
    sink(face, measure_face(balls, boundary, face));
  }
}

// Angle of the arc that the walk at a use of a ball leaves along.
double arc_angle(const BallSet &balls, const BoundaryStructure &boundary, uint32_t ball, uint32_t use);

// Where a vertex lies relative to the centre of one of its balls, in lattice steps.
void vertex_offset(const exact::Plane &P, const exact::Plane &Q, int sign, double root_D, double offset[3]);

// The circle of two spheres, in lattice steps, relative to the centre of the first ball; the axis is a unit vector from
// that ball towards the second.
struct CirclePlace {
  double centre[3];
  double axis[3];
  double radius;
};
CirclePlace circle_place(const BallSet &balls, uint32_t first, uint32_t second);

}  // namespace hsp
