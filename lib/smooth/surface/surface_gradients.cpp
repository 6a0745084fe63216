#include "surface/surface_gradients.hpp"

#include "surface/saddle.hpp"
#include "surface/vertex_contacts.hpp"
#include "surface/weighted_joints.hpp"

namespace hsp {
namespace {

Vec3 by_centre(const double (&a)[4]) {
  return {a[0], a[1], a[2]};
}

// Adds the concave patch at a vertex of ball i; `offset` leads from the ball's centre to it. Returns the factor of the
// vertex's velocity in the derivatives of the area.
Vec3 add_concave(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t i, uint32_t vertex,
                 const Vec3 &offset, SurfaceGradient &result) {
  const double p = static_cast<double>(balls.probe_steps);
  const ConcavePatch patch = surface.patch(vertex);
  result.measure.concave += patch.area / 3;
  result.measure.volume += patch.volume / 3;
  const double root = boundary.root_discriminant(vertex);
  result.degenerate = result.degenerate || boundary.vertex(vertex).tied() || root == 0.0;
  CreaseSums creases;
  for (const uint32_t piece : surface.cut_patches().pieces(vertex)) {
    const CreaseSums &own = surface.cut_patches().piece(piece).creases;
    creases.directions = creases.directions + own.directions;
    creases.angle += own.angle;
  }
  result.area_offset += (2 * patch.area / p - p * creases.angle) / 3;
  const Vec3 q_area = combine(2 * p, patch.vector_area, -p, creases.directions);
  if (root == 0.0) return q_area;

  const Vec3 q_volume = -p * p * patch.vector_area;
  const VertexContacts contacts(balls, boundary, vertex, i, offset);
  const Vec3 n = contacts.normal[0];
  const double z_area = dot(q_area, contacts.share);
  const double z_volume = dot(q_volume, contacts.share);
  result.area_centre = combine(1.0, result.area_centre, z_area, n);
  result.area_radius += z_area;
  result.volume_centre = combine(1.0, result.volume_centre, z_volume, n);
  result.volume_radius += z_volume;
  return q_area;
}

// The gradient of one of a ball's faces, or of all if `one` is no_id.
SurfaceGradient gradient_of_faces(const BallSet &balls, const Boundary &boundary, const Surface &surface,
                                  const AreaWeights &weights, uint32_t i, uint32_t one) {
  SurfaceGradient result;
  const double R = balls.r[i];
  FreeSurface face(boundary, R);
  ArcBatches arcs(balls, boundary, i, one);
  SaddlePatches saddles(balls, boundary, i);
  const bool weighted = weights.weight != nullptr;
  WeightedJoints joints(balls, boundary, surface, weights, i);
  double triple_volume = 0.0;
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    face.add(batch);
    for (uint32_t s = 0; s < batch.count && balls.probe_steps > 0; ++s) {
      if (batch.arc[s] == 0) continue;
      const uint32_t vertex = boundary.half_edge(arcs.half_edge(s)).vertex;
      const Vec3 offset = 0.5 * Vec3{batch.px[s], batch.py[s], batch.pz[s]};
      const Vec3 q_area = add_concave(balls, boundary, surface, i, vertex, offset, result);
      if (weighted && boundary.root_discriminant(vertex) > 0.0) joints.add_vertex(vertex, offset, q_area);
    }
    // Without a probe an arc is the limit of its saddle; a circle of radius 0 is not.
    result.degenerate = result.degenerate || (balls.probe_steps == 0 && batch.any_touching);
    const SaddleDerivatives saddle = saddles.differentiate(batch);
    result.measure.saddle += saddle.measures.area;
    triple_volume += saddle.measures.triple_volume;
    result.area_centre = result.area_centre + by_centre(saddle.area);
    result.volume_centre = result.volume_centre + by_centre(saddle.volume);
    result.area_radius += saddle.area[3];
    result.volume_radius += saddle.volume[3];
    result.area_offset += saddle.area_offset;
    if (weighted) joints.add_saddles(batch, saddles);
  }
  const ConvexPatches convex(balls, boundary, i, one, face);
  const double r = R - static_cast<double>(balls.probe_steps), shrinkage = shrinkage_of_faces(balls, i);
  result.measure.convex = convex.area;
  result.measure.volume += (triple_volume + convex.triple_volume) / 3;
  result.volume_centre = combine(1.0, result.volume_centre, shrinkage * shrinkage, convex.vector_area);
  result.volume_radius += convex.area;
  result.area_centre = combine(1.0, result.area_centre, R > 0.0 ? 2 * shrinkage / R : 0.0, convex.vector_area);
  result.area_radius += 2 * r * convex.steradians;
  result.area_offset -= 2 * r * convex.steradians;
  if (weighted) result.weigh(joints.weight(), joints.sums());
  return result;
}

}  // namespace

SurfaceGradient surface_gradient_of_ball(const BallSet &balls, const Boundary &boundary, const Surface &surface,
                                         const AreaWeights &weights, uint32_t i) {
  SurfaceGradient sum;
  for_each_chosen_part(boundary, surface.chosen(), i,
                       [&](uint32_t one) { sum += gradient_of_faces(balls, boundary, surface, weights, i, one); });
  return sum;
}

}  // namespace hsp
