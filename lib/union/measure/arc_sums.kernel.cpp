#include "measure/arc_kernel.hpp"

namespace hsp::HSP_TARGET {

bool evaluate_arcs(const BallOfSet &ball, ArcBatch &batch) {
  return ArcKernel<register_lanes>::evaluate(ball, batch);
}
void complete_arcs(ArcBatch &batch) {
  ArcKernel<register_lanes>::complete_arcs(batch);
}
AreaSums sum_areas(const ArcBatch &batch, double radius) {
  return ArcKernel<register_lanes>::sum_areas(batch, radius);
}
GradientSums sum_gradient(const ArcBatch &batch, double radius, double weight) {
  return ArcKernel<register_lanes>::sum_gradient(batch, radius, weight);
}

}  // namespace hsp::HSP_TARGET
