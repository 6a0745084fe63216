// A saddle patch of the smooth surface as a band: the probe turns about the axis of two balls, and its profile leads
// from one ball to the other. With e the direction from the axis to the probe's centre and u the axis from ball 0 to
// ball 1, in the caller's order, the point at profile angle a and its outward normal are (saddle_kernel.hpp)
//   centre + p (sin a u - cos a e),   cos a e - sin a u,
// a from -t0 to t1. Where the axis cuts the patch, a ends at a cusp, -tc or tc. Turns run counter-clockwise about u:
// then turns and profile, in this order, run counter-clockwise seen from outside.
#pragma once

#include "core/elementary.hpp"
#include "mesh/mesh_curve.hpp"

namespace hsp {

class SaddleBand {
 public:
  // The band of an arc or a circle.
  SaddleBand(const BallSet &balls, const Boundary &boundary, LoopElement on_ball_1, bool has_cusps);

  uint32_t ball(uint32_t side) const { return ball_[side]; }
  bool has_cusps() const { return has_cusps_; }
  uint32_t parts() const { return has_cusps_ ? 2 : 1; }
  double way_of_probe() const { return angle_ * radius_; }
  // The length of the longer one of the two curves where it touches the balls.
  double width() const;
  // The length of its profile: of one part, at a ball, if there are cusps.
  double length(uint32_t part) const { return probe_ * (last(part) - first(part)); }

  // The unit vector e at k of `segments` turns, and at an end of the arc.
  Vec3 outward(uint32_t k, uint32_t segments) const;
  Vec3 outward_at_end(uint32_t end) const { return end_[end]; }
  // The position of the probe's centre; on a circle of at least this radius.
  Position probe(const Vec3 &outward, double least_radius = 0.0) const {
    return {centre_.ball, centre_.offset + (radius_ < least_radius ? least_radius : radius_) * outward};
  }
  // The point on a ball there, and its normal.
  struct Point {
    Position position;
    Vec3 normal;
    uint32_t ball;
  };
  Point on_ball(uint32_t side, const Vec3 &outward) const;
  // The ball on whose side of the waist the middle of a row of `rows` lies.
  uint32_t ball_of_row(uint32_t part, uint32_t row, uint32_t rows) const {
    return ball_[has_cusps_ ? part : profile(part, (row + 0.5) / rows) > 0.0 ? 1U : 0U];
  }
  // The point at l of `segments` along the profile.
  Point at(const Vec3 &outward, uint32_t part, uint32_t l, uint32_t segments) const;

 private:
  double first(uint32_t part) const { return part == 0 ? -tilt_[0] : cusp_; }
  double last(uint32_t part) const { return part == 1 || !has_cusps_ ? tilt_[1] : -cusp_; }

  double profile(uint32_t part, double share) const { return first(part) + share * (last(part) - first(part)); }

  const BallSet &balls_;
  uint32_t ball_[2];
  bool has_cusps_;
  Position centre_;
  Vec3 axis_;
  double radius_, angle_, probe_;
  double tilt_[2];  // t0, t1
  double cusp_;     // tc
  Vec3 end_[2];
};

}  // namespace hsp
