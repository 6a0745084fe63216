#include "measure/arc_kernel.hpp"

namespace hsp {

using Kernel = ArcKernel<baseline_lanes>;

bool evaluate_arcs(const BallOfSet &ball, ArcBatch &batch) {
  return Kernel::evaluate(ball, batch);
}
AreaSums sum_areas(const ArcBatch &batch, double radius) {
  return Kernel::sum_areas(batch, radius);
}
WeightedSums sum_weighted(const ArcBatch &batch, double radius, double weight) {
  return Kernel::sum_weighted(batch, radius, weight);
}

}  // namespace hsp
