#include "measure/gradients.hpp"

namespace hsp {
namespace {

// The arcs of ball k in the weighted sum of areas (arc_kernel.hpp).
class WeightedAreas {
 public:
  WeightedAreas(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k)
      : balls_(balls), boundary_(boundary), weights_(weights), R_(balls.r[k]), weight_(weights.of(balls, k)) {}

  // What does not count is taken out of the batch.
  void add(ArcBatch &batch) {
    if (batch.any_touching) [[unlikely]]
      take_out_uncounted(batch);
    for (uint32_t s = 0; s < batch.count; ++s) {
      const uint32_t j = batch.other[s];
      batch.other_weight[s] = weights_.of(balls_, j) * balls_.r[j];
    }
    for (uint32_t s = batch.count; s < batch.count + sum_lanes - 1; ++s) batch.other_weight[s] = 0.0;
    const WeightedSums sums = sums_of(batch);
    centre_ = centre_ + Vec3{sums.centre[0], sums.centre[1], sums.centre[2]};
    radius_ += sums.radius;
  }

  const Vec3 &by_centre() const { return centre_; }
  double by_radius(double steradians) const { return 2 * weight_ * R_ * steradians + radius_; }

 private:
  WeightedSums sums_of(const ArcBatch &batch) const {
#if HSP_AVX2
    if (boundary_.has_wide_code()) return sum_weighted_avx2(batch, R_, weight_);
#endif
    return sum_weighted(batch, R_, weight_);
  }
  void take_out_uncounted(ArcBatch &batch) const {
    for (uint32_t s = 0; s < batch.count; ++s) {
      if (!counts(batch.touching[s], weights_.touching_balls)) {
        batch.angle[s] = batch.Xx[s] = batch.Xy[s] = batch.Xz[s] = 0.0;
      }
    }
  }

  const BallSet &balls_;
  [[maybe_unused]] const Boundary &boundary_;  // says whether there is code for wide registers
  const AreaWeights &weights_;
  const double R_, weight_;
  Vec3 centre_{0.0, 0.0, 0.0};
  double radius_ = 0.0;
};

}  // namespace

BallGradient gradient_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k) {
  BallGradient result;
  const uint32_t faces = boundary.faces(k).size();
  if (faces == 0) return result;
  WeightedAreas areas(balls, boundary, weights, k);
  FreeSurface surface(boundary, balls.r[k]);
  ArcBatches arcs(balls, boundary, k);
  while (arcs.next()) {
    ArcBatch &batch = arcs.batch();
    surface.add(batch);
    areas.add(batch);
    result.one_sided = result.one_sided || batch.any_touching;
  }
  const double R = balls.r[k];
  const uint32_t loops = boundary.loops(k).size();
  const double steradians = surface.steradians(faces, loops);
  result.centre = areas.by_centre();
  result.radius = areas.by_radius(steradians);
  result.vector_area = surface.vector_area();
  result.measure.area = R * R * steradians;
  result.measure.volume =
      volume_term(R, result.measure.area, offset_from_origin(balls, boundary, k), result.vector_area);
  return result;
}

uint32_t area_row_length(const Boundary &boundary, uint32_t i) {
  if (!boundary.is_exposed(i)) return 0;
  uint32_t length = 1 + boundary.circles(i).size();
  const IdRange half_edges = boundary.half_edges(i);
  for (const uint32_t u : half_edges) {
    // Uses are sorted by the circle they leave along.
    length += u == half_edges.first || boundary.half_edge(u).circle != boundary.half_edge(u - 1).circle ? 1U : 0U;
  }
  return length;
}

}  // namespace hsp
