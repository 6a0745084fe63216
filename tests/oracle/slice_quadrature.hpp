// Areas and volume of a union of balls by slicing it with planes of constant z.
#ifndef HARDSPHERE_TESTS_ORACLE_SLICE_QUADRATURE_HPP
#define HARDSPHERE_TESTS_ORACLE_SLICE_QUADRATURE_HPP

#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

struct RealBall {
  long double x = 0;
  long double y = 0;
  long double z = 0;
  long double radius = 0;
};

struct SliceMeasures {
  long double area = 0;
  long double volume = 0;
  std::vector<long double> ball_area;
};

/// A plane cuts the balls into discs. A ball's free area is the integral over z of its radius times the free angle of
/// its disc (Archimedes), the volume that of the area of the union of the discs. Between two heights at which the
/// picture in the plane changes (ends of balls, ends of intersection circles, points of three spheres) both integrands
/// are smooth but for roots at the ends, which tanh-sinh quadrature takes in its stride. step: that of the quadrature's
/// parameter; 0.1 gives about 15 digits for sets of tens of balls of comparable size. Of equal balls the first has the
/// area.
SliceMeasures measure_by_slices(const std::vector<RealBall> &balls, long double step = 0.1L);

std::vector<RealBall> real_balls(const Balls &balls);

}  // namespace oracle

#endif
