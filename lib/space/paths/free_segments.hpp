// Whether a segment between two points of the lattice is outside all balls, decided in integers.
//
// Let d = b - a and p = c - a for a ball of centre c and radius R. If d.p <= 0, the point a is nearest to c; if d.p >=
// |d|^2, the point b. Else the segment is outside the ball if |p|^2 |d|^2 - (d.p)^2 > R^2 |d|^2. Coordinates are below
// 2^52, so that d and p are below 2^53, their products below 2^108 and every term below 2^217: 128 and 256 bits
// suffice. Doubles answer first; the error of |p x d|^2 is below 64 u |p|^2 |d|^2.
#pragma once

#include "cells/free_space.hpp"

namespace hsp {

inline double distance(const exact::Vector &a, const exact::Vector &b) {
  const Vec3 d = to_double(a - b);
  return std::sqrt(dot(d, d));
}

// Whether the segment has no point of the ball, not even on its sphere.
bool is_outside_ball(const BallSet &balls, uint32_t ball, const exact::Vector &a, const exact::Vector &b);
// Whether the segment has no point of any ball. Looks at the cubes along it.
bool is_free_segment(const BallSet &balls, const FreeSpace &space, const exact::Vector &a, const exact::Vector &b);
// The least distance of the segment from one ball, negative inside, in lattice steps.
double clearance_of_ball(const BallSet &balls, uint32_t ball, const exact::Vector &a, const exact::Vector &b);
// The least distance of the segment from any ball, negative inside, in lattice steps; infinite without balls.
double segment_clearance(const BallSet &balls, const exact::Vector &a, const exact::Vector &b);

}  // namespace hsp
