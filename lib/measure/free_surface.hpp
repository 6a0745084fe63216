// Area and vector area of the free part of one sphere, or of one of its faces, from its arcs:
//   area / r^2 = 2 pi (2 #faces - #loops) + sum over arcs of cos(cap) angle - sum over vertices of the exterior angle
//   N = -1/2 sum over arcs from p to q, counter-clockwise, of [ m x (q - p) + rho^2 angle u ]
// (Gauss-Bonnet; vector area by Stokes), with u, m and rho the circle's axis, centre and radius.
#pragma once

#include "measure/circle_geometry.hpp"

namespace hsp {

struct FreeSurface {
  double cosines = 0.0;
  double exteriors = 0.0;
  exact::DoubleVector twice_vector_area{0.0, 0.0, 0.0};

  // X = 2 (q - p) x u; as m = h u, m x (q - p) = -h X / 2.
  void add_arc(const CircleOrigin &origin, const Circle &circle, double angle, const exact::DoubleVector &X) {
    cosines += circle.cap_cosine * angle;
    twice_vector_area =
        exact::combine(1.0, twice_vector_area, 1.0,
                       exact::combine(0.5 * circle.height, X, -origin.radius_squared(circle) * angle, circle.axis));
  }

  // A face can be infinitesimal: its area is 0 up to rounding, on either side.
  double steradians(uint32_t faces, uint32_t loops) const {
    const double characteristic = 2.0 * static_cast<double>(faces) - static_cast<double>(loops);
    const double sum = 2 * pi * characteristic + cosines - exteriors;
    return sum > 0.0 ? sum : 0.0;
  }
  exact::DoubleVector vector_area() const {
    return {0.5 * twice_vector_area.x, 0.5 * twice_vector_area.y, 0.5 * twice_vector_area.z};
  }
};

// Ball i's centre seen from the origin of its component, which is its ball of lowest rank, so that terms of the volume
// do not grow with the distance to other components.
inline exact::DoubleVector arm_of(const BallSet &balls, const BoundaryStructure &boundary, uint32_t i) {
  const uint32_t origin = boundary.components.root(i);
  return {balls.x[i] - balls.x[origin], balls.y[i] - balls.y[origin], balls.z[i] - balls.z[origin]};
}

}  // namespace hsp
