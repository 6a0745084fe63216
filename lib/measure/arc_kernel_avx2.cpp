#if HSP_AVX2
#include "measure/arc_kernel.hpp"

namespace hsp {

using Kernel = ArcKernel<4>;

bool evaluate_arcs_avx2(const BallOfSet &ball, ArcBatch &batch) {
  return Kernel::evaluate(ball, batch);
}
void complete_arcs_avx2(ArcBatch &batch) {
  Kernel::complete_arcs(batch);
}
AreaSums sum_areas_avx2(const ArcBatch &batch, double radius) {
  return Kernel::sum_areas(batch, radius);
}
GradientSums sum_gradient_avx2(const ArcBatch &batch, double radius, double weight) {
  return Kernel::sum_gradient(batch, radius, weight);
}

}  // namespace hsp
#endif
