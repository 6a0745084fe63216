#if HSP_AVX2
#include "measure/arc_kernel.hpp"

namespace hsp {

bool evaluate_arcs_avx2(const BallOfSet &ball, ArcBatch &batch) {
  return ArcKernel<4>::evaluate(ball, batch);
}
void complete_arcs_avx2(ArcBatch &batch) {
  ArcKernel<4>::complete_arcs(batch);
}
AreaSums sum_areas_avx2(const ArcBatch &batch, double radius) {
  return ArcKernel<4>::sum_areas(batch, radius);
}
GradientSums sum_gradient_avx2(const ArcBatch &batch, double radius, double weight) {
  return ArcKernel<4>::sum_gradient(batch, radius, weight);
}

}  // namespace hsp
#endif
