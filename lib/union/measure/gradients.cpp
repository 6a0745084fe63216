#include "measure/gradients.hpp"

namespace hsp {

void WeightedAreas::put_given_weights(ArcBatch &batch) const {
  for (uint32_t s = 0; s < batch.count; ++s) {
    const uint32_t j = batch.other[s];
    batch.other_weight[s] = weights_.of(balls_, j) * balls_.r[j];
  }
  for (uint32_t k = 0; k < sum_lanes - 1; ++k) batch.other_weight[batch.count + k] = 0.0;
}

void WeightedAreas::take_out_uncounted(ArcBatch &batch) const {
  for (uint32_t s = 0; s < batch.count; ++s) {
    if (!counts(batch.touching[s], weights_.touching_balls)) {
      batch.angle[s] = batch.Xx[s] = batch.Xy[s] = batch.Xz[s] = 0.0;
    }
  }
}

BallGradient gradient_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k) {
  BallGradient result;
  if (boundary.is_exposed(k)) gather_gradient(balls, boundary, weights, k, result, [](const ArcBatch &) {});
  return result;
}

uint32_t area_row_length(const Boundary &boundary, uint32_t i) {
  uint32_t length = 0;
  visit_balls_of_area_row(boundary, i, [&](uint32_t, uint32_t) { ++length; });
  return length;
}

void find_area_row_starts(const CubeGrid &grid, const Boundary &boundary, uint32_t *first) {
  first[0] = 0;
  for (uint32_t i = 0; i < grid.balls().n; ++i) first[i + 1] = first[i] + area_row_length(boundary, grid.grid_index(i));
}

}  // namespace hsp
