#if HSP_AVX2
#include "surface/saddle_kernel.hpp"

namespace hsp {

using Kernel = SaddleKernel<4>;

bool find_circle_radii_avx2(const ArcBatch &batch, double radius, double (&circle_radius)[ArcBatch::room]) {
  return Kernel::find_radii(batch, radius, circle_radius);
}
SaddleMeasures measure_saddles_avx2(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                                    const RolledBall &ball) {
  return Kernel::measure(batch, circle_radius, ball);
}
SaddleDerivatives differentiate_saddles_avx2(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                                             const RolledBall &ball) {
  return Kernel::differentiate(batch, circle_radius, ball);
}

}  // namespace hsp
#endif
