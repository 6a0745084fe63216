#include "surface/saddle_kernel.hpp"

namespace hsp::HSP_TARGET {

bool find_saddle_circles(const ArcBatch &batch, const RolledBall &ball, SaddleCircles &circles) {
  return SaddleKernel<register_lanes>::find_circles(batch, ball, circles);
}
SaddleMeasures measure_saddles(const ArcBatch &batch, const SaddleCircles &circles, const RolledBall &ball) {
  return SaddleKernel<register_lanes>::measure(batch, circles, ball);
}
SaddleDerivatives differentiate_saddles(const ArcBatch &batch, const SaddleCircles &circles, const RolledBall &ball) {
  return SaddleKernel<register_lanes>::differentiate(batch, circles, ball);
}

}  // namespace hsp::HSP_TARGET
