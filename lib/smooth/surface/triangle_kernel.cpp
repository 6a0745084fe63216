#include "surface/triangle_kernel.hpp"

namespace hsp {

void place_probes(const BallArrays &balls, ProbeTriangles &triangles) {
  TriangleKernel<baseline_lanes>::place(balls, triangles);
}
void measure_triangles(const BallArrays &balls, ProbeTriangles &triangles) {
  TriangleKernel<baseline_lanes>::measure(balls, triangles);
}

}  // namespace hsp
