// Where probes stand and the triangles they see, four at a time: the vertex of three spheres, the directions from it to
// their centres, the great circles through these and what lies between them, as plain arrays that kernels for registers
// of several widths fill with the same bits (triangle_kernel.hpp).
#pragma once

#include <cstdint>

#include "lanes/target.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

struct ProbeTriangles {
  static constexpr uint32_t lanes = 4;

  // Given: the balls by rank, 1 or -1 for p+ or p- of the circles of balls 1 and 2 on ball 0, sqrt(D).
  uint32_t ball[3][lanes];
  double sign[lanes];
  double root_discriminant[lanes];

  // From the centre of ball 0 to the vertex; place_probes writes NaN where doubles are not precise enough.
  double offset[3][lanes];

  // measure_triangles finds the rest: unit vectors from the vertex to the three centres; of side k, which faces ball k,
  // the unit normal towards ball k and the cosine of its length; the largest error of these normals in units of that of
  // the vertex's position; solid angle and vector area of the unit sphere's triangle. No solid angle is less than 0; it
  // is -1 where a side has no direction, because two of the centres are in line with the vertex.
  double corner[3][3][lanes];  // [ball][x, y, z][lane]
  double inward[3][3][lanes];
  double cosine[3][lanes];
  double side_error[lanes];
  double steradians[lanes];
  double vector_area[3][lanes];
};

// Lanes that are not needed must repeat another one.
HSP_KERNEL(void, place_probes, (const BallArrays &balls, ProbeTriangles &triangles), (balls, triangles))
HSP_KERNEL(void, measure_triangles, (const BallArrays &balls, ProbeTriangles &triangles), (balls, triangles))

}  // namespace hsp
