#include "measure/gradients.hpp"

namespace hsp {

using exact::combine;
using exact::DoubleVector;

// With s the weights, ball k's own area and those of its neighbours give together, per arc,
//   dS/dc_k: u phi [ -s_k R_k (1 - h/d) - s_j R_j h/d ] + (q - p) x u [ s_k R_k - s_j R_j ]/d
//   dS/dR_k: s_k phi (R_k^2/d - h) - s_j R_j R_k phi / d,   as (R_k^2 + R_j^2 - d^2)/(2 d) = R_k^2/d - h
// of which what has the factor s_k R_k - s_j R_j vanishes for equal balls.
// For R_k = 0 a sphere has no arcs but infinitely short ones, and every term is 0.
BallGradient gradient_of_ball(const BallSet &balls, const BoundaryStructure &boundary, const AreaWeights &weights,
                              uint32_t k) {
  BallGradient result;
  const uint32_t faces = boundary.first_face[k + 1] - boundary.first_face[k];
  if (faces == 0) return result;
  const double R = balls.r[k];
  const double own_weight = weights.of(balls, k);
  const double own = own_weight * R;
  const LoopWalk walk(balls, boundary, k);
  FreeSurface surface;
  surface.exteriors = walk.visit(no_id, [&](const Circle &circle, double angle, const DoubleVector &X) {
    surface.add_arc(walk.origin(), circle, angle, X);
    result.one_sided = result.one_sided || circle.touching != Touching::no;
    if (!counts(circle, weights.touching_balls)) return;
    const double difference = own - weights.of(balls, circle.other) * balls.r[circle.other];
    const double over_distance = difference * circle.inverse_distance;
    const double along = angle * (over_distance * circle.height - own);
    result.centre = combine(1.0, result.centre, 1.0, combine(along, circle.axis, 0.5 * over_distance, X));
    result.radius += angle * (R * over_distance - own_weight * circle.height);
  });
  const double steradians = surface.steradians(faces, boundary.first_loop[k + 1] - boundary.first_loop[k]);
  result.radius += 2 * own * steradians;
  result.vector_area = surface.vector_area();
  result.measure.area = R * R * steradians;
  result.measure.volume = (R * result.measure.area + exact::dot(arm_of(balls, boundary, k), result.vector_area)) / 3;
  return result;
}

uint32_t area_row_length(const BoundaryStructure &boundary, uint32_t i) {
  if (boundary.first_face[i + 1] == boundary.first_face[i]) return 0;
  uint32_t length = 1 + boundary.first_circle_side[i + 1] - boundary.first_circle_side[i];
  for (uint32_t u = boundary.first_use[i]; u < boundary.first_use[i + 1]; ++u) {
    // Uses are sorted by the circle they leave along.
    length += u == boundary.first_use[i] || boundary.uses[u].out != boundary.uses[u - 1].out ? 1U : 0U;
  }
  return length;
}

}  // namespace hsp
