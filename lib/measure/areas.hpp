// Areas and volume of the union: Gauss-Bonnet on each sphere, and the divergence theorem over all of them.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// One ball's part, in lattice steps.
struct BallMeasure {
  double area = 0.0;    // of its free faces
  double volume = 0.0;  // its term of the volume
};

// Ball i of the grid's order. Sums run in the order of its half-edges and circles, which does not depend on ids.
BallMeasure measure_ball(const BallSet &balls, const Boundary &boundary, uint32_t i);

// The same for one face alone: its area, and its term of the volume about the same origin.
BallMeasure measure_face(const BallSet &balls, const Boundary &boundary, uint32_t face);

// Calls sink(face, measure) for every face of ball i, ascending.
template <class Sink>
void measure_faces(const BallSet &balls, const Boundary &boundary, uint32_t i, Sink sink) {
  for (const uint32_t face : boundary.faces(i)) {
    sink(face, measure_face(balls, boundary, face));
  }
}

// Angle of the arc that the walk at a use of a ball leaves along.
double arc_angle(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t half_edge);

}  // namespace hsp
