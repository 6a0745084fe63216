#if HSP_AVX2
#include "surface/triangle_kernel.hpp"

namespace hsp {

void place_probes_avx2(const BallArrays &balls, ProbeTriangles &triangles) {
  TriangleKernel<4>::place(balls, triangles);
}
void measure_triangles_avx2(const BallArrays &balls, ProbeTriangles &triangles) {
  TriangleKernel<4>::measure(balls, triangles);
}

}  // namespace hsp
#endif
