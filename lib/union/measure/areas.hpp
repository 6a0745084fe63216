// Areas and volume of the union: Gauss-Bonnet on each sphere, and the divergence theorem over all of them.
//
// As an example two balls of radius 5 at 0 and (8,0,0), with u = x and a common circle of radius 3 in the plane x = 4.
// Each has one face and one loop, so that its area is 25 (2 pi (2 - 1) + 4/5 * 2 pi) = 90 pi. Its vector area is minus
// that of the circle's disc: N = -9 pi u for the first ball and 9 pi u for the second one. Terms of the volume are
// (r area + c.N) / 3, with c the centre relative to the origin of the component, which is the first ball's centre here:
//   first    5 * 90 pi / 3 = 150 pi
//   second   (5 * 90 pi + 8 * 9 pi) / 3 = 174 pi         sum 324 pi: twice a ball less a cap, (500 - 14) pi / 3
#pragma once

#include "measure/arc_batches.hpp"

namespace hsp {

// Area and vector area of the free part of one sphere, or of one of its faces, from its arcs:
//   area / r^2 = 2 pi (2 #faces - #loops) + sum over arcs of cos(cap) angle - sum over vertices of the exterior angle
//   N = -1/2 sum over arcs from p to q, counter-clockwise, of [ m x (q - p) + rho^2 angle u ]
// (Gauss-Bonnet; vector area by Stokes), with u, m and rho the circle's axis, centre and radius.
class FreeSurface {
 public:
  FreeSurface(const Boundary &boundary, double radius) : boundary_(boundary), radius_(radius) {}

  void add(const ArcBatch &batch) { add(batch, sums_of(batch)); }
  // The same for callers that have the batch's sums.
  void add(const ArcBatch &batch, const AreaSums &sums) {
    exterior_angles_ += batch.exterior_angles;
    exterior_turns_ += batch.exterior_turns;
    cosines_ += sums.cosines;
    vector_area_ = vector_area_ + Vec3{sums.vector_area[0], sums.vector_area[1], sums.vector_area[2]};
  }

  // area / r^2, not negative. Multiples of 2 pi are counted as integers. A face can be infinitesimal: the sum is 0 up
  // to rounding, and may be below 0.
  double steradians(uint32_t faces, uint32_t loops) const {
    const double turns = 2.0 * static_cast<double>(faces) - static_cast<double>(loops) - exterior_turns_;
    const double cosines = radius_ > 0.0 ? cosines_ / (2 * radius_) : 0.0;
    const double sum = 2 * pi * turns + (cosines - exterior_angles_ + 2 * pi_low * turns);
    return sum > 0.0 ? sum : 0.0;
  }
  Vec3 vector_area() const { return 0.125 * vector_area_; }

 private:
  AreaSums sums_of(const ArcBatch &batch) const { return sum_areas(boundary_.target(), batch, radius_); }

  const Boundary &boundary_;
  double radius_;
  double exterior_angles_ = 0.0, exterior_turns_ = 0.0;
  double cosines_ = 0.0;             // sum of 2 h angle
  Vec3 vector_area_{0.0, 0.0, 0.0};  // eight times the vector area
};

// The centre of ball i relative to the centre of its component's ball of lowest rank. With this origin terms of the
// volume do not grow with the distance to other components.
inline Vec3 offset_from_origin(const BallSet &balls, const Boundary &boundary, uint32_t i) {
  return balls.difference(boundary.component_origin(i), i);
}

// One ball's term of the volume, from its radius, area and vector area.
inline double volume_term(double radius, double area, const Vec3 &offset, const Vec3 &vector_area) {
  return (radius * area + dot(offset, vector_area)) / 3;
}

// One ball's part, in lattice steps.
struct BallMeasure {
  double area = 0.0;    // of its free faces
  double volume = 0.0;  // its term of the volume
};

// The measure of ball i, in grid order. Sums run in the order of its half-edges and circles, which does not depend on
// ids.
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

// The angle of the arc of a half-edge of a ball.
double angle_of(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t half_edge);

}  // namespace hsp
