// The two kinds of curves that a map consists of, with their parameters.
//
// Silhouette of a ball: its points at the height of the centre, at the angle t, counter-clockwise in the view plane
// with the ball on the left.
//
// Crease of two balls, `far` and `near`: the points m + rho (a cos t + b sin t), where a is the steepest direction in
// the plane of the circle and b a horizontal one, so that the height m_z + rise cos t is largest at 0 and falls to
// either side. The nearer ball is on the left. Seen is at most what is above the centre of the nearer ball: below, the
// nearer ball covers it. At the height of that centre the crease goes over into the silhouette of the nearer ball.
// Balls that only touch have none: roundings would decide where it ends.
#pragma once

#include "core/elementary.hpp"
#include "core/vec3.hpp"
#include "maps/seen_balls.hpp"

namespace hsp {

// How deep a point is behind the front of a ball, inside it or below its centre in its disc: the square of the radius
// less that of the distance, negative if it is not behind.
inline double depth_behind(const Vec3 &point, const SeenBall &ball) {
  const double dx = point.x - ball.x;
  const double dy = point.y - ball.y;
  const double dz = point.z - ball.z;
  const double squared = ball.r * ball.r - dx * dx - dy * dy;
  return dz > 0.0 ? squared - dz * dz : squared;
}
inline bool is_behind(const Vec3 &point, const SeenBall &ball) {
  return depth_behind(point, ball) > 0.0;
}

inline Vec3 silhouette_point(const SeenBall &ball, double t) {
  const SinCos at = sin_cos(t);
  return {ball.x + ball.r * at.cosine, ball.y + ball.r * at.sine, ball.z};
}

struct Crease {
  Vec3 m{}, a{}, b{};  // a and b of length 1
  double rho = 0.0;
  double rise = 0.0;
  double end = 0.0;  // what may be seen is |t| <= end; pi for the whole circle
  bool exists = false;

  Crease(const SeenBall &far, const SeenBall &near) {
    const Vec3 d{near.x - far.x, near.y - far.y, near.z - far.z};
    const double squared = dot(d, d);
    const double sum = far.r + near.r;
    const double difference = far.r - near.r;
    if (squared >= sum * sum * (1.0 - touching) || squared <= difference * difference) return;
    const double distance = std::sqrt(squared);
    const double height = 0.5 * (distance + difference * sum / distance);
    const double rho_squared = (far.r - height) * (far.r + height);
    if (!(rho_squared > 0.0)) return;
    rho = std::sqrt(rho_squared);
    const Vec3 n{d.x / distance, d.y / distance, d.z / distance};
    m = combine(1.0, {far.x, far.y, far.z}, height, n);
    const double slope = std::sqrt(n.x * n.x + n.y * n.y);
    a = slope > 0.0 ? Vec3{-n.z * (n.x / slope), -n.z * (n.y / slope), slope} : Vec3{1.0, 0.0, 0.0};
    b = slope > 0.0 ? Vec3{n.y / slope, -n.x / slope, 0.0} : Vec3{0.0, 1.0, 0.0};
    rise = rho * slope;
    const double needed = near.z - m.z;
    const double reach = rise * (1.0 - touching);
    if (needed >= reach) return;
    end = needed <= -reach ? pi : arc_tangent(std::sqrt((rise - needed) * (rise + needed)), needed);
    exists = true;
  }

  bool is_whole() const { return end == pi; }
  Vec3 at(const SinCos &t) const { return combine(1.0, m, 1.0, combine(rho * t.cosine, a, rho * t.sine, b)); }
  Vec3 at(double t) const { return at(sin_cos(t)); }
};

}  // namespace hsp
