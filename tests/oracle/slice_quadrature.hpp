// Areas, vector areas and volume of a union of balls by slicing it with planes of constant z, in long doubles: no
// faces, and none of the formulas for spherical polygons that the library sums.
#pragma once

#include <array>
#include <vector>

#include "slices.hpp"

namespace oracle {

struct SliceMeasures {
  long double area = 0;
  long double volume = 0;
  std::vector<long double> ball_area;
  std::vector<std::array<long double, 3>> ball_vector_area;  // integral of the outward unit normal over the free part
};

// A plane cuts the balls into discs. A ball's free area is the integral over z of its radius times the free angle of
// its disc (Archimedes). Its vector area is the integral of the outward normal with the same measure. The volume is the
// integral over z of the area of the union of the discs. `step` is the step of the quadrature's parameter: 0.1 gives
// about 15 digits for sets of tens of balls of comparable size. Of equal balls the first has the area.
SliceMeasures measure_by_slices(const std::vector<RealBall> &balls, long double step = 0.1L);

}  // namespace oracle
