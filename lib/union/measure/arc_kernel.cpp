#include "measure/arc_kernel.hpp"

namespace hsp {

using Kernel = ArcKernel<baseline_lanes>;

bool evaluate_arcs(const BallOfSet &ball, ArcBatch &batch) {
  return Kernel::evaluate(ball, batch);
}
void complete_arcs(ArcBatch &batch) {
  Kernel::complete_arcs(batch);
}
AreaSums sum_areas(const ArcBatch &batch, double radius) {
  return Kernel::sum_areas(batch, radius);
}
GradientSums sum_gradient(const ArcBatch &batch, double radius, double weight) {
  return Kernel::sum_gradient(batch, radius, weight);
}

}  // namespace hsp
