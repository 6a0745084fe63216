#include "surface/saddle_kernel.hpp"

namespace hsp::HSP_TARGET {

bool find_circle_radii(const ArcBatch &batch, double radius, double (&circle_radius)[ArcBatch::room]) {
  return SaddleKernel<register_lanes>::find_radii(batch, radius, circle_radius);
}
SaddleMeasures measure_saddles(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                               const RolledBall &ball) {
  return SaddleKernel<register_lanes>::measure(batch, circle_radius, ball);
}
SaddleDerivatives differentiate_saddles(const ArcBatch &batch, const double (&circle_radius)[ArcBatch::room],
                                        const RolledBall &ball) {
  return SaddleKernel<register_lanes>::differentiate(batch, circle_radius, ball);
}

}  // namespace hsp::HSP_TARGET
