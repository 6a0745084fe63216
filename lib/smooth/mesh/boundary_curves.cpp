#include "mesh/boundary_curves.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {

CurvePoints::CurvePoints(const BallSet &balls, const Boundary &boundary, const MeshCurve &curve, bool is_circle,
                         double least_radius)
    : segments_(curve.segments) {
  uint32_t own;
  uint32_t other;
  if (is_circle) {
    const uint32_t *const ball = boundary.circle(curve.element).ball;
    const uint32_t lower = balls.ranks_before(ball[0], ball[1]) ? 0 : 1;
    own = ball[lower];
    other = ball[1 - lower];
  } else {
    own = boundary.ball_of(curve.element);
    other = boundary.half_edge(curve.element).circle;
  }
  const CirclePosition circle = position_of_circle(balls, own, other);
  ball_ = own;
  centre_ = circle.centre.offset;
  if (is_circle) {
    angle_ = 2 * pi;
    x_ = (circle.radius < least_radius ? least_radius : circle.radius) * perpendicular_to(circle.axis);
  } else {
    const Position start = position_of_vertex(balls, boundary, boundary.half_edge(curve.element).vertex);
    angle_ = angle_of(balls, boundary, own, curve.element);
    x_ = balls.difference(own, start.ball) + start.offset - centre_;
  }
  y_ = cross(x_, circle.axis);
}

double length_of_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge) {
  const uint32_t own = boundary.ball_of(half_edge);
  return angle_of(balls, boundary, own, half_edge) *
         CircleGeometry(balls, own, boundary.half_edge(half_edge).circle).radius;
}

double segments_of_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge, double length) {
  return segments_of(length_of_arc(balls, boundary, half_edge), length,
                     has_ends_of_same_balls(boundary, half_edge) ? 2.0 : 1.0);
}

double segments_of_circle(const BallSet &balls, const Boundary &boundary, uint32_t circle, double length) {
  const CircleRecord &record = boundary.circle(circle);
  const double radius = CircleGeometry(balls, record.ball[0], record.ball[1]).radius;
  return segments_of(2 * pi * radius, length, fewest_of_circle);
}

void BoundaryCurves::carve(Workspace &workspace, uint32_t curves) {
  curve_of_ = workspace.take<uint32_t>(2 * uint64_t{curves});
  curve_ = workspace.take<MeshCurve>(curves);
}

bool BoundaryCurves::build(const BallSet &balls, const Boundary &boundary, double length, Patience &patience) {
  double all = 0.0;
  count_ = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (!patience.allows(100 + 500 * uint64_t{boundary.half_edges(i).size()})) return false;
    for (const uint32_t e : boundary.half_edges(i)) {
      if (!balls.ranks_before(i, boundary.half_edge(e).circle)) continue;
      const double segments = segments_of_arc(balls, boundary, e, length);
      all += segments;
      if (!(all < max_count)) return false;
      curve_of_[e] = curve_of_[boundary.twin(e)] = count_;
      curve_[count_++] = {e, static_cast<uint32_t>(segments), 0, false, false};
    }
  }
  first_circle_ = count_;
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    if (!patience.allows(500)) return false;
    const double segments = segments_of_circle(balls, boundary, c, length);
    all += segments;
    if (!(all < max_count)) return false;
    curve_[count_++] = {c, static_cast<uint32_t>(segments), 0, false, false};
  }
  return true;
}

}  // namespace hsp
