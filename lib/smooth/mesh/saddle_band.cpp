#include "mesh/saddle_band.hpp"

#include "sphere/arc_geometry.hpp"
#include "surface/saddle.hpp"
#include "surface/surface_areas.hpp"

namespace hsp {

SaddleBand::SaddleBand(const BallSet &balls, const Boundary &boundary, LoopElement on_ball_1, bool has_cusps)
    : balls_(balls),
      ball_{boundary.neighbour(on_ball_1), boundary.ball_of(on_ball_1)},
      has_cusps_(has_cusps),
      probe_(static_cast<double>(balls.probe_steps)) {
  const CirclePosition circle = position_of_circle(balls, ball_[0], ball_[1]);
  centre_ = circle.centre;
  axis_ = circle.axis;
  radius_ = circle.radius;
  for (uint32_t side = 0; side < 2; ++side) {
    tilt_[side] = arc_tangent(CircleGeometry(balls, ball_[side], ball_[1 - side]).height, radius_);
  }
  cusp_ = has_cusps ? arc_tangent(half_way_between_cusps(balls, ball_[0], ball_[1]), radius_) : 0.0;
  // If the two differ by rounding alone, nothing lies between them.
  for (double &tilt : tilt_) tilt = has_cusps && tilt < cusp_ ? cusp_ : tilt;
  angle_ = 2 * pi;
  end_[0] = end_[1] = perpendicular_to(axis_);
  if (on_ball_1.is_circle()) return;
  const uint32_t half_edge = on_ball_1.half_edge();
  angle_ = angle_of_arc(balls, boundary, half_edge);
  const uint32_t vertex[2] = {boundary.half_edge(half_edge).vertex, boundary.end_vertex(half_edge)};
  for (uint32_t end = 0; end < 2; ++end) {
    const Vec3 arm = direction_from(balls, centre_.ball, position_of_vertex(balls, boundary, vertex[end]));
    end_[end] = unit(arm - centre_.offset, end_[end]);
  }
}

double SaddleBand::width() const {
  double share = 0.0;
  for (const uint32_t b : ball_) {
    const double own = shrinkage_of_faces(balls_, b);
    if (own > share) share = own;
  }
  return angle_ * radius_ * share;
}

Vec3 SaddleBand::outward(uint32_t k, uint32_t segments) const {
  const SinCos turn = sin_cos(angle_ * k / segments);
  return combine(turn.cosine, end_[0], turn.sine, cross(axis_, end_[0]));
}

SaddleBand::Point SaddleBand::on_ball(uint32_t side, const Vec3 &outward) const {
  const uint32_t own = ball_[side];
  const Vec3 arm = direction_from(balls_, own, probe(outward));
  return {{own, shrinkage_of_faces(balls_, own) * arm}, unit(arm, side == 0 ? axis_ : -axis_), own};
}

SaddleBand::Point SaddleBand::at(const Vec3 &outward, uint32_t part, uint32_t l, uint32_t segments) const {
  const double angle = profile(part, static_cast<double>(l) / segments);
  const SinCos profile = sin_cos(angle);
  const Vec3 normal = combine(profile.cosine, outward, -profile.sine, axis_);
  const Position centre = probe(outward);
  const uint32_t side = has_cusps_ ? part : angle > 0.0 ? 1U : 0U;
  return {{centre.ball, centre.offset - probe_ * normal}, normal, ball_[side]};
}

}  // namespace hsp
