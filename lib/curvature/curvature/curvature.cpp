#include "curvature/curvature.hpp"

#include <initializer_list>

#include "curvature/edge_sums.hpp"

namespace hsp {
namespace {

int32_t gauss_of_ball(const Boundary &boundary, uint32_t i) {
  const auto count = [](uint32_t n) { return static_cast<int32_t>(n); };
  return 6 * (2 * count(boundary.faces(i).size()) - count(boundary.loops(i).size())) -
         count(boundary.half_edges(i).size());
}

// Whether a vertex of the ball is decided by the symbolic perturbation.
bool has_tied_vertex(const Boundary &boundary, uint32_t k) {
  bool tied = false;
  for (const uint32_t e : boundary.half_edges(k)) tied |= boundary.vertex(boundary.half_edge(e).vertex).tied();
  return tied;
}

// The part of a weighted M that belongs to the edges and vertices of ball k.
class MeanCurvature {
 public:
  MeanCurvature(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k,
                const CurvedSet &set)
      : balls_(balls),
        boundary_(boundary),
        weights_(weights),
        k_(k),
        weight_(weights.of(balls, k)),
        has_plain_squares_(set.has_plain_squares),
        has_tied_vertex_(set.has_tied_vertices && has_tied_vertex(boundary, k)) {
    result.one_sided = has_tied_vertex_;
  }

  HSP_INLINE_UNLESS_SMALL void add(const ArcBatch &batch) {
    EdgeBatch edges;
    fill(batch, edges);
    const EdgeSums sums = sums_of(batch, edges);
    result.mean += sums.mean;
    result.centre = result.centre + Vec3{sums.centre[0], sums.centre[1], sums.centre[2]};
    result.radius += sums.radius;
    result.one_sided = result.one_sided || batch.any_touching;
    if (has_tied_vertex_) [[unlikely]]
      release_unmoved_ends(batch, edges);
  }
  void add_area(double steradians) {
    result.mean += weight_ * balls_.r[k_] * steradians;
    // d(A/r)/dr = 2 A/r^2 - A/r^2, plus the terms of the arcs.
    result.radius += weight_ * steradians;
  }

  // Adds the terms of add(), each times the offset at which it acts (edge_kernel.hpp has their formulas).
  void add_strain(const ArcBatch &batch, StrainSum &sum) {
    EdgeBatch edges;
    fill(batch, edges);
    static_cast<void>(sums_of(batch, edges));
    for (uint32_t s = 0; s < batch.count; ++s) add_strain_of_slot(batch, edges, s, sum);
  }

  MeanCurvatureGradient result;

 private:
  void fill(const ArcBatch &batch, EdgeBatch &edges) const {
    edges.has_weights = !weights_.are_ones();
    edges.has_plain_squares = has_plain_squares_;
    if (!edges.has_weights) return;
    for (uint32_t s = 0; s < batch.count; ++s) edges.weight[s] = weights_.of(balls_, batch.other[s]);
    for (uint32_t s = batch.count; s < batch.count + sum_lanes - 1; ++s) edges.weight[s] = 0.0;
  }

  void add_strain_of_slot(const ArcBatch &batch, const EdgeBatch &edges, uint32_t s, StrainSum &sum) const {
    const double pull = edges.pull[s];
    if (batch.any_touching && batch.touching[s] != Touching::no) return;  // an edge without length
    const Vec3 v{batch.vx[s], batch.vy[s], batch.vz[s]};
    const Vec3 u{batch.ux[s], batch.uy[s], batch.uz[s]};
    const double inverse = batch.inverse_distance[s];
    const double h = 0.5 * batch.twice_height[s];
    const double other_h = std::sqrt(dot(v, v)) - h;
    const double other_weight = edges.weight_of(s);
    const double shared = 0.5 * (weight_ + other_weight);
    const double along =
        batch.angle[s] * (0.5 * (shared - pull * h * other_h) - (weight_ * other_h + other_weight * h) * inverse);
    sum.add(-0.5 * along, u, v);
    if (batch.arc[s] == 0) return;
    const Vec3 X{batch.Xx[s], batch.Xy[s], batch.Xz[s]};
    sum.add(-0.25 * (weight_ - other_weight) * inverse, X, v);
    const auto add_end = [&](uint32_t slot, double sign) {
      if (!(batch.root_discriminant[slot] > 0.0)) return;  // the vertex counts as unmoved
      const Vec3 x{batch.px[slot], batch.py[slot], batch.pz[slot]};
      sum.add(sign * 0.125 * pull * other_h, cross(x, u), x);
    };
    add_end(s, 1.0);
    add_end(batch.next[s], -1.0);
    const double root = batch.root_discriminant[s];
    if (!(root > 0.0)) return;
    const double lambda = (edges.force[s] + edges.pull[batch.previous[s]] * edges.force_by_previous[s]) / root;
    const Vec3 x{batch.px[s], batch.py[s], batch.pz[s]};
    sum.add(-0.25 * lambda, x, x);
  }

  EdgeSums sums_of(const ArcBatch &batch, EdgeBatch &edges) const {
    return differentiate_edges(boundary_.target(), balls_.r[k_], batch, weight_, edges);
  }

  // A vertex with D = 0 has no derivative, and counts as unmoved. So the motion of its balls must not count there
  // either: else M would change when all balls move together.
  void release_unmoved_ends(const ArcBatch &batch, const EdgeBatch &edges) {
    for (uint32_t s = 0; s < batch.count; ++s) {
      if (batch.arc[s] == 0) continue;
      const Vec3 u{batch.ux[s], batch.uy[s], batch.uz[s]};
      const double other_h = 1.0 / batch.inverse_distance[s] - 0.5 * batch.twice_height[s];
      const auto release = [&](uint32_t slot, double sign) {
        if (batch.root_discriminant[slot] > 0.0) return;
        const Vec3 x{batch.px[slot], batch.py[slot], batch.pz[slot]};
        result.centre = combine(1.0, result.centre, sign * 0.25 * edges.pull[s] * other_h, cross(x, u));
      };
      release(s, 1.0);
      release(batch.next[s], -1.0);
    }
  }

  const BallSet &balls_;
  const Boundary &boundary_;
  const AreaWeights &weights_;
  const uint32_t k_;
  const double weight_;
  const bool has_plain_squares_, has_tied_vertex_;
};

// In multiples of the unit no sum of two radii is above 2^26, so that its square is at most 2^52. The distance of
// spheres that meet is at most that sum.
bool has_plain_squares(const BallSet &balls, Target target) {
  double unit = 1.0;
  while (static_cast<double>(balls.largest_radius) > 0x1p25 * unit) unit *= 2;
  bool plain = true;
  for (const Span<double> *numbers : {&balls.x, &balls.y, &balls.z, &balls.r}) {
    plain = plain && (unit == 1.0 || are_multiples(target, numbers->data(), balls.n, unit));
  }
  return plain;
}

}  // namespace

CurvedSet curved_set(const BallSet &balls, const Boundary &boundary) {
  uint32_t codes = 0;
  for (uint32_t v = 0; v < boundary.vertex_count(); ++v) codes |= boundary.vertex(v).code;
  return {(codes & VertexRecord::tied_bit) != 0, has_plain_squares(balls, boundary.target())};
}

BallCurvature curvature_of_ball(const BallSet &balls, const Boundary &boundary, uint32_t i) {
  BallCurvature result;
  const uint32_t faces = boundary.faces(i).size();
  if (faces == 0) return result;
  FreeSurface surface(boundary, balls.r[i]);
  ArcBatches arcs(balls, boundary, i);
  double edges = 0.0;
  while (arcs.next()) {
    surface.add(arcs.batch());
    edges += sum_edges(boundary.target(), ball_of_set(balls, i), arcs.batch());
  }
  result.mean = balls.r[i] * surface.steradians(faces, boundary.loops(i).size()) - 0.5 * edges;
  result.gauss = gauss_of_ball(boundary, i);
  return result;
}

CurvedBallGradient curved_gradient_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights,
                                           uint32_t k, const CurvedSet &set) {
  CurvedBallGradient result;
  if (!boundary.is_exposed(k)) return result;
  MeanCurvature curvature(balls, boundary, weights, k, set);
  curvature.add_area(gather_gradient(balls, boundary, weights, k, result.measures,
                                     [&curvature](const ArcBatch &batch) { curvature.add(batch); }));
  result.curvature = curvature.result;
  return result;
}

void add_curvature_strain_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights,
                                  uint32_t k, StrainSum &sum) {
  if (!boundary.is_exposed(k)) return;
  MeanCurvature curvature(balls, boundary, weights, k, {false, false});
  ArcBatches arcs(balls, boundary, k);
  while (arcs.next()) curvature.add_strain(arcs.batch(), sum);
}

}  // namespace hsp
