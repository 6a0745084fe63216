#include "surface/triangle_kernel.hpp"

namespace hsp::HSP_TARGET {

void place_probes(const BallArrays &balls, ProbeTriangles &triangles) {
  TriangleKernel<register_lanes>::place(balls, triangles);
}
void measure_triangles(const BallArrays &balls, ProbeTriangles &triangles) {
  TriangleKernel<register_lanes>::measure(balls, triangles);
}

}  // namespace hsp::HSP_TARGET
