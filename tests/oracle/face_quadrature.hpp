// The faces of a union of balls one by one, by slicing it with planes of constant z.
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

// The maximal free pieces of the spheres, in no particular order. Between two heights at which the picture in the
// slice changes, a free arc sweeps over a strip; strips of one ball in neighbouring slabs are of one face if their
// arcs overlap at the height between them. For balls in general position: no tangencies, no four spheres through a
// point.
std::vector<FaceMeasures> measure_faces_by_slices(const std::vector<RealBall> &balls, long double step = 0.1L);

}  // namespace oracle
