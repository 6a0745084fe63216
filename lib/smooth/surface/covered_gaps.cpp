#include "surface/covered_gaps.hpp"

#include "exact/angular_order.hpp"

namespace hsp {

// Each ball covers an arc of the circle, whose mid-point lies in the direction of the ball's centre
// (exact/angular_order.hpp). Among the balls at ends of gaps, the one that covers the end of this gap has the first
// mid-point after that of the ball that covers its start.
uint32_t vertex_across_gap(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, uint32_t ball,
                           uint32_t half_edge) {
  const HalfEdge &start = boundary.half_edge(half_edge);
  const auto direction = [&](uint32_t other) { return balls.exact_difference(ball, other); };
  const uint32_t previous_circle = boundary.previous_circle(ball, start);
  uint32_t best = no_id, best_cover = no_id;
  for (const uint32_t e : boundary.half_edges(ball)) {
    if (boundary.half_edge(e).circle != start.circle) continue;
    if (!chosen.all() && !chosen.together(boundary.face_of(e), boundary.face_of(half_edge))) continue;
    const HalfEdge &next = boundary.half_edge(boundary.half_edge(e).next);
    const bool nearer = best == no_id || next.circle == previous_circle ||
                        (best_cover != previous_circle &&
                         exact::counter_clockwise_before(direction(start.circle), direction(previous_circle),
                                                         direction(next.circle), direction(best_cover)));
    if (!nearer) continue;
    best = next.vertex;
    best_cover = next.circle;
  }
  return best;
}

}  // namespace hsp
