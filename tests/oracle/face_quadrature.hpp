// Areas and vector areas of the faces of a union of balls, one by one, by slicing the union with planes of constant z.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "slices.hpp"

namespace oracle {

struct FaceMeasures {
  size_t ball = 0;
  long double area = 0;
  std::array<long double, 3> vector_area = {0, 0, 0};  // integral of the outward unit normal
};

// The faces, which are the maximal free pieces of the spheres, in no particular order. Between two heights at which the
// picture in the slice changes, a free arc sweeps over a strip. Strips of one ball in neighbouring slabs belong to one
// face if their arcs overlap at the height between the slabs. For balls in general position: no tangencies, no four
// spheres through a point.
std::vector<FaceMeasures> measure_faces_by_slices(const std::vector<RealBall> &balls, long double step = 0.1L);

}  // namespace oracle
