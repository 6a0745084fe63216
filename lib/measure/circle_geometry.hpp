// The circle in which the sphere of one ball meets that of another, in lattice steps, seen from the first ball's
// centre.
#pragma once

#include "boundary/structure.hpp"
#include "exact/exact_predicates.hpp"
#include "exact/filter.hpp"

namespace hsp {

// Two spheres that touch meet in a circle of radius 0, exactly known from integers.
enum class Touching : uint8_t { no, from_outside, from_inside };

struct Circle {
  exact::Vector v;           // from the ball's centre to the other ball's, and
  double h;                  // the circle's plane as in lib/exact: v.y = h with y twice the place on the sphere
  exact::DoubleVector axis;  // v / d, with d = |v|
  double inverse_distance;   // 1/d
  double height;             // of the circle's plane along the axis: h / (2 d)
  double cap_cosine;         // height / r, of the angle between the axis and the circle; 0 for r = 0
  uint32_t other;            // the other ball
  Touching touching;
  bool plain;  // the radius is at least r/8, so that arcs and vertices on it need no integers
};

// A ball as the origin of its circles.
struct CircleOrigin {
  exact::LatticeBall ball;
  double radius;
  double inverse_radius;  // 0 for radius 0

  CircleOrigin(const BallSet &balls, uint32_t i)
      : ball(balls.ball(i)), radius(balls.r[i]), inverse_radius(radius > 0.0 ? 1.0 / radius : 0.0) {}

  Circle circle(const BallSet &balls, uint32_t other) const {
    const exact::LatticeBall far = balls.ball(other);
    const exact::Plane P = exact::plane_of(ball, far);
    const int64_t U = exact::dot(P.v, P.v);
    const int64_t sum = ball.radius + far.radius;
    const int64_t difference = ball.radius - far.radius;
    Circle circle;
    circle.v = P.v;
    circle.h = static_cast<double>(P.h);
    circle.inverse_distance = 1.0 / std::sqrt(static_cast<double>(U));
    circle.axis = {static_cast<double>(P.v.x) * circle.inverse_distance,
                   static_cast<double>(P.v.y) * circle.inverse_distance,
                   static_cast<double>(P.v.z) * circle.inverse_distance};
    circle.height = 0.5 * circle.h * circle.inverse_distance;
    circle.cap_cosine = circle.height * inverse_radius;
    circle.other = other;
    circle.touching = U == sum * sum                 ? Touching::from_outside
                      : U == difference * difference ? Touching::from_inside
                                                     : Touching::no;
    // (1 - cos)(1 + cos) is the square of the circle's radius over r.
    circle.plain = (1.0 - circle.cap_cosine) * (1.0 + circle.cap_cosine) >= 1.0 / 64 && radius > 0.0;
    return circle;
  }
  // The square of a circle's radius.
  double radius_squared(const Circle &circle) const {
    if (circle.touching != Touching::no) return 0.0;
    const double squared = (radius - circle.height) * (radius + circle.height);
    return squared > 0.0 ? squared : 0.0;
  }
};

}  // namespace hsp
