#include "surface/covered_gaps.hpp"

#include "core/elementary.hpp"
#include "exact/angular_order.hpp"
#include "exact/predicates.hpp"

namespace hsp {

// Every ball covers an arc whose mid-point lies in the direction of its centre (exact/angular_order.hpp), and the ball
// that covers the end of the gap has the first such mid-point after that of the ball that covers its start.
CoveredGap gap_behind(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, uint32_t ball,
                      uint32_t half_edge) {
  const HalfEdge &start = boundary.half_edge(half_edge);
  const auto direction = [&](uint32_t other) { return balls.exact_difference(ball, other); };
  const uint32_t previous_circle = boundary.previous_circle(ball, start);
  CoveredGap best{no_id, no_id};
  uint32_t best_cover = no_id;
  for (const uint32_t e : boundary.half_edges(ball)) {
    if (boundary.half_edge(e).circle != start.circle) continue;
    if (!chosen.all() && !chosen.together(boundary.face_of(e), boundary.face_of(half_edge))) continue;
    const HalfEdge &next = boundary.half_edge(boundary.half_edge(e).next);
    const bool nearer = best.vertex == no_id || next.circle == previous_circle ||
                        (best_cover != previous_circle &&
                         exact::counter_clockwise_before(direction(start.circle), direction(previous_circle),
                                                         direction(next.circle), direction(best_cover)));
    if (!nearer) continue;
    best = {next.vertex, e};
    best_cover = next.circle;
  }
  return best;
}

double angle_of_gap(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t half_edge,
                    const CoveredGap &gap) {
  using exact::Exact;
  const HalfEdge &start = boundary.half_edge(half_edge);
  const uint32_t first = boundary.previous_circle(ball, start);
  const uint32_t last = boundary.half_edge(boundary.half_edge(gap.half_edge).next).circle;
  const exact::LatticeBall own = balls.ball(ball);
  const exact::Plane circle = exact::plane_of(own, balls.ball(start.circle));
  const double distance = std::sqrt(static_cast<double>(dot(circle.v, circle.v)));
  // Half of what a ball covers; 0/0 is the limit of the symbolic perturbation, as in sphere/arc_geometry.cpp.
  const auto half = [&](uint32_t cover, uint32_t vertex) {
    const double y = boundary.root_discriminant(vertex) * distance;
    const double x = Exact::radical_coordinate(circle, exact::plane_of(own, balls.ball(cover)));
    return y == 0.0 && x == 0.0 ? pi / 2 : arc_tangent(y, x);
  };
  double turn = 0.0;
  if (first != last) {
    const exact::Vector from = balls.exact_difference(ball, first);
    const exact::Vector to = balls.exact_difference(ball, last);
    turn =
        arc_tangent(Exact::triple_product(circle.v, from, to) * distance, Exact::cross_dot_cross(circle.v, from, to));
    if (turn < 0.0) turn += 2 * pi;
  }
  const double angle = turn + half(first, start.vertex) + half(last, gap.vertex);
  return angle < 2 * pi ? angle : 2 * pi;
}

}  // namespace hsp
