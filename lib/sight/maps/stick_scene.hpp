// The curves that bound what is seen of balls and sticks, by names, as points in space.
//
// Bodies are numbered as in stick_sweep.hpp: balls by their ids, then part p of stick k as balls + 2 k + p. A curve is
// named like an edge of a visibility map, by a body and a nearer one:
//   ball, none    the silhouette, at the angle t
//   part, none    the two lines of the contour: with s along the axis the right one at t = s / length and the left one
//                 at t = -s / length. So the part is always on the left
//   ball, ball    their crease, with the nearer one on the left
//   ball, part    where a stick leaves the ball at its foot: a half circle with the stick on the left
//   part, part    where the halves of a stick meet, with the nearer half on the left
//   part, ball    where a stick enters the ball at its top, with the ball on the left: as much of the half circle as is
//                 above the ball's centre
// On half circles t = 0 is in the middle, and t increases from the left of the stick to its right.
#pragma once

#include "maps/curves.hpp"
#include "maps/stick_view.hpp"

namespace hsp {

// The points middle + cos t first + sin t second.
struct RoundCurve {
  Vec3 middle, first, second;

  Vec3 at(double t) const {
    const SinCos at = sin_cos(t);
    return combine(1.0, middle, 1.0, combine(at.cosine, first, at.sine, second));
  }
};

// The points start + t step.
struct StraightCurve {
  Vec3 start, step;

  Vec3 at(double t) const { return combine(1.0, start, t, step); }
};

enum class StickRing : uint32_t { foot = 0, middle = 1, top = 2 };

struct StickScene {
  Span<const SeenBall> balls;  // grid order
  Span<const Stick> sticks;

  bool is_ball(uint32_t body) const { return body < balls.size(); }
  uint32_t stick_of(uint32_t body) const { return (body - balls.size()) / 2; }
  uint32_t part_of(uint32_t body) const { return (body - balls.size()) % 2; }
  uint32_t body_of(uint32_t stick, uint32_t part) const { return balls.size() + 2 * stick + part; }
  const Stick &stick_at(uint32_t body) const { return sticks[stick_of(body)]; }
  bool is_straight(uint32_t body, uint32_t nearer) const { return nearer == no_id && !is_ball(body); }

  StickRing ring_of(uint32_t body, uint32_t nearer) const {
    return is_ball(body) ? StickRing::foot : is_ball(nearer) ? StickRing::top : StickRing::middle;
  }

  // All but contours of sticks.
  RoundCurve round_curve(uint32_t body, uint32_t nearer) const {
    if (nearer == no_id) {
      const SeenBall &ball = balls[body];
      return {{ball.x, ball.y, ball.z}, {ball.r, 0.0, 0.0}, {0.0, ball.r, 0.0}};
    }
    if (is_ball(body) && is_ball(nearer)) {
      const Crease crease(balls[body], balls[nearer]);
      return {crease.m, crease.rho * crease.a, crease.rho * crease.b};
    }
    const Stick &stick = stick_at(is_ball(body) ? nearer : body);
    const StickRing ring = ring_of(body, nearer);
    const double s = ring == StickRing::foot ? stick.first : ring == StickRing::top ? stick.last : stick.middle();
    const double up = -stick.axis.z;
    return {stick.on_axis(s), stick.radius * Vec3{up * stick.e[0], up * stick.e[1], stick.seen},
            stick.radius * Vec3{stick.e[1], -stick.e[0], 0.0}};
  }

  StraightCurve line_of(const Stick &stick, bool left) const {
    const double side = left ? stick.radius : -stick.radius;
    return {stick.foot + side * Vec3{-stick.e[1], stick.e[0], 0.0}, (left ? -stick.length : stick.length) * stick.axis};
  }

  Vec3 at(uint32_t body, uint32_t nearer, double t) const {
    return is_straight(body, nearer) ? line_of(stick_at(body), t < 0.0).at(t) : round_curve(body, nearer).at(t);
  }

  // The parameter of a point of the view plane on the contour of a body.
  double landing(uint32_t body, double x, double y) const {
    if (is_ball(body)) return arc_tangent(y - balls[body].y, x - balls[body].x);
    const Stick &stick = stick_at(body);
    const double dx = x - stick.foot.x;
    const double dy = y - stick.foot.y;
    const double part = (dx * stick.e[0] + dy * stick.e[1]) / (stick.seen * stick.length);
    return dy * stick.e[0] - dx * stick.e[1] > 0.0 ? -part : part;
  }
};

// The front of a stick over a point of the view plane: its height, and the place along the axis.
struct StickFront {
  bool exists;  // only between the centres of its balls
  double z, s;
  double beside;  // how far inside the contour: the radius less the distance from the axis as it is seen
};

inline StickFront front_of(const Stick &stick, double x, double y) {
  const double dx = x - stick.foot.x;
  const double dy = y - stick.foot.y;
  const double a = dx * stick.e[0] + dy * stick.e[1];
  const double w = std::fabs(dy * stick.e[0] - dx * stick.e[1]);
  const double beside = stick.radius - w;
  if (!(beside > 0.0)) return {false, 0.0, 0.0, beside};
  const double v = std::sqrt(beside * (stick.radius + w));
  const double s = (a + stick.axis.z * v) / stick.seen;
  return {s > 0.0 && s < stick.length, stick.foot.z + (a * stick.axis.z + v) / stick.seen, s, beside};
}

}  // namespace hsp
