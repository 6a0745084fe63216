#if HSP_AVX2
#include "surface/saddle_kernel.hpp"

namespace hsp {

bool find_circle_radii_avx2(const ArcBatch &batch, double radius, double (&circle_radius)[ArcBatch::room]) {
  return SaddleKernel<4>::find_radii(batch, radius, circle_radius);
}
SaddleMeasures measure_saddles_avx2(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                                    const RolledBall &ball) {
  return SaddleKernel<4>::measure(batch, circle_radius, ball);
}
SaddleDerivatives differentiate_saddles_avx2(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                                             const RolledBall &ball) {
  return SaddleKernel<4>::differentiate(batch, circle_radius, ball);
}

}  // namespace hsp
#endif
