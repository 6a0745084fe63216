#include "mesh/boundary_curves.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {

namespace {

// A direction perpendicular to a unit vector: away from its longest axis.
Vec3 perpendicular_to(const Vec3 &axis) {
  const double x = std::fabs(axis.x);
  const double y = std::fabs(axis.y);
  const double z = std::fabs(axis.z);
  const Vec3 other = x <= y && x <= z ? Vec3{1.0, 0.0, 0.0} : y <= z ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
  const Vec3 across = cross(axis, other);
  return 1.0 / std::sqrt(dot(across, across)) * across;
}

double segments_of(double length_of_curve, double length) {
  const double wanted = length_of_curve / length;
  const double floor = wanted < 0x1p30 ? static_cast<double>(static_cast<int64_t>(wanted)) : wanted;
  return floor < wanted ? floor + 1.0 : floor;
}

}  // namespace

CurvePoints::CurvePoints(const BallSet &balls, const Boundary &boundary, const BoundaryCurve &curve, bool is_circle,
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

// Both ends of an arc may be of the same three balls. Then there may be another arc between them, and not both may be
// one segment.
double segments_of_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge, double length) {
  const HalfEdge &start = boundary.half_edge(half_edge);
  const uint32_t own = boundary.ball_of(half_edge);
  const double radius = CircleGeometry(balls, own, start.circle).radius;
  const double segments = segments_of(angle_of(balls, boundary, own, half_edge) * radius, length);
  const bool same_balls = boundary.half_edge(start.next).circle == boundary.previous_circle(own, start);
  const double fewest = same_balls ? 2.0 : 1.0;
  return segments < fewest ? fewest : segments;
}

double segments_of_circle(const BallSet &balls, const Boundary &boundary, uint32_t circle, double length) {
  const CircleRecord &record = boundary.circle(circle);
  const double radius = CircleGeometry(balls, record.ball[0], record.ball[1]).radius;
  const double segments = segments_of(2 * pi * radius, length);
  constexpr double fewest = 6.0;
  return segments < fewest ? fewest : segments;
}

void BoundaryCurves::carve(Workspace &workspace, uint32_t curves) {
  curve_of_ = workspace.take<uint32_t>(2 * uint64_t{curves});
  curve_ = workspace.take<BoundaryCurve>(curves);
}

bool BoundaryCurves::build(const BallSet &balls, const Boundary &boundary, double length) {
  double all = 0.0;
  count_ = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
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
    const double segments = segments_of_circle(balls, boundary, c, length);
    all += segments;
    if (!(all < max_count)) return false;
    curve_[count_++] = {c, static_cast<uint32_t>(segments), 0, false, false};
  }
  return true;
}

}  // namespace hsp
