#include "surface/saddle_kernel.hpp"

namespace hsp {

using Kernel = SaddleKernel<baseline_lanes>;

bool find_circle_radii(const ArcBatch &batch, double radius, double (&circle_radius)[ArcBatch::room]) {
  return Kernel::find_radii(batch, radius, circle_radius);
}
SaddleMeasures measure_saddles(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                               const RolledBall &ball) {
  return Kernel::measure(batch, circle_radius, ball);
}
SaddleDerivatives differentiate_saddles(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                                        const RolledBall &ball) {
  return Kernel::differentiate(batch, circle_radius, ball);
}

}  // namespace hsp
