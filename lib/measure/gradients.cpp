#include "measure/gradients.hpp"

namespace hsp {
namespace {

// With s the weights, ball k's own area and those of its neighbours give together, per arc,
//   dS/dc_k: u phi [ -s_k R_k (1 - h/d) - s_j R_j h/d ] + (q - p) x u [ s_k R_k - s_j R_j ]/d
//   dS/dR_k: s_k phi (R_k^2/d - h) - s_j R_j R_k phi / d,   as (R_k^2 + R_j^2 - d^2)/(2 d) = R_k^2/d - h
// The term with the factor s_k R_k - s_j R_j vanishes for equal balls. A sphere with R_k = 0 has only infinitely short
// arcs, and every term is 0.
class WeightedAreas {
 public:
  WeightedAreas(const BallSet &balls, const AreaWeights &weights, uint32_t k)
      : balls_(balls), weights_(weights), R_(balls.r[k]), weight_(weights.of(balls, k)) {}

  // Slots c and c + 1 of a batch.
  void add(const ArcBatch &batch, uint32_t c, const ArcLanes &arc) {
    const Lanes others{of_other(batch.other[c]), of_other(batch.other[c + 1])};
    const Lanes half = 0.5 * (weight_ * R_ - others) * arc.inverse_distance;
    Lanes angle = arc.angle;
    LaneVector X = arc.X;
    if (batch.any_touching) [[unlikely]] {
      const LaneMask counted{counts(batch.touching[c], weights_.touching_balls) ? -1 : 0,
                             counts(batch.touching[c + 1], weights_.touching_balls) ? -1 : 0};
      angle = mask_and(counted, angle);
      X = mask_and(counted, X);
    }
    centre_ = centre_ + (angle * (half * arc.twice_height - weight_ * R_) * arc.axis + half * X);
    radius_ += angle * (2 * R_ * half - 0.5 * weight_ * arc.twice_height);
  }

  Vec3 by_centre() const { return {sum_of(centre_.x), sum_of(centre_.y), sum_of(centre_.z)}; }
  double by_radius(double steradians) const { return 2 * weight_ * R_ * steradians + sum_of(radius_); }

 private:
  double of_other(uint32_t j) const { return weights_.of(balls_, j) * balls_.r[j]; }

  const BallSet &balls_;
  const AreaWeights &weights_;
  const double R_, weight_;
  LaneVector centre_{{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
  Lanes radius_{0.0, 0.0};
};

}  // namespace

BallGradient gradient_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k) {
  BallGradient result;
  const uint32_t faces = boundary.faces(k).size();
  if (faces == 0) return result;
  WeightedAreas areas(balls, weights, k);
  FreeSurface surface(balls.r[k]);
  ArcBatches arcs(balls, boundary, k);
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    for (uint32_t c = 0; c < batch.count; c += lane_count) {
      const ArcLanes arc = batch.lanes(c);
      surface.add(arc);
      areas.add(batch, c, arc);
    }
    result.one_sided = result.one_sided || batch.any_touching;
  }
  const double R = balls.r[k];
  const uint32_t loops = boundary.loops(k).size();
  const double steradians = surface.steradians(faces, loops, arcs.exterior_angle_sum());
  result.centre = areas.by_centre();
  result.radius = areas.by_radius(steradians);
  result.vector_area = surface.vector_area();
  result.measure.area = R * R * steradians;
  result.measure.volume =
      (R * result.measure.area + dot(offset_from_origin(balls, boundary, k), result.vector_area)) / 3;
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
