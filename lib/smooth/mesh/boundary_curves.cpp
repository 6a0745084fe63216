#include "mesh/boundary_curves.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

double angle_of_curve(const BallSet &balls, const Boundary &boundary, LoopElement e) {
  return e.is_circle() ? 2 * pi : angle_of(balls, boundary, boundary.ball_of(e), e.half_edge());
}

}  // namespace

CirclePoints points_of_curve(const BallSet &balls, const Boundary &boundary, LoopElement e, double least_radius) {
  const uint32_t own = boundary.ball_of(e);
  const CirclePosition circle = position_of_circle(balls, own, boundary.neighbour(e));
  CirclePoints points{{own, circle.centre.offset}, angle_of_curve(balls, boundary, e), {}, {}};
  if (e.is_circle()) {
    points.x = (circle.radius < least_radius ? least_radius : circle.radius) * perpendicular_to(circle.axis);
  } else {
    const Position start = position_of_vertex(balls, boundary, boundary.half_edge(e.half_edge()).vertex);
    points.x = balls.difference(own, start.ball) + start.offset - points.centre.offset;
  }
  points.y = cross(points.x, circle.axis);
  return points;
}

double length_of_curve(const BallSet &balls, const Boundary &boundary, LoopElement e) {
  return angle_of_curve(balls, boundary, e) * CircleGeometry(balls, boundary.ball_of(e), boundary.neighbour(e)).radius;
}

double segments_of_curve(const BallSet &balls, const Boundary &boundary, LoopElement e, double length) {
  return segments_of(length_of_curve(balls, boundary, e), length, fewest_segments(boundary, e));
}

void BoundaryCurves::carve(Workspace &workspace, uint32_t curves) {
  curve_of_ = workspace.take<uint32_t>(2 * uint64_t{curves});
  curve_ = workspace.take<MeshCurve>(curves);
}

bool BoundaryCurves::build(const BallSet &balls, const Boundary &boundary, double length, Patience &patience) {
  double all = 0.0;
  count_ = 0;
  const auto add = [&](LoopElement e) {
    const double segments = segments_of_curve(balls, boundary, e, length);
    all += segments;
    if (!(all < max_count)) return false;
    curve_[count_++] = {e, static_cast<uint32_t>(segments), 0, false, false};
    return true;
  };
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (!patience.allows(100 + 500 * uint64_t{boundary.half_edges(i).size()})) return false;
    for (const uint32_t e : boundary.half_edges(i)) {
      if (!balls.ranks_before(i, boundary.half_edge(e).circle)) continue;
      curve_of_[e] = curve_of_[boundary.twin(e)] = count_;
      if (!add(LoopElement::arc(e))) return false;
    }
  }
  first_circle_ = count_;
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    if (!patience.allows(500)) return false;
    const uint32_t *const ball = boundary.circle(c).ball;
    if (!add(LoopElement::circle({c, balls.ranks_before(ball[0], ball[1]) ? 0U : 1U}))) return false;
  }
  return true;
}

}  // namespace hsp
