#include "excluded_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oracle {
namespace {

Point plus(const Point &a, double t, const Point &b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
double scalar(const Point &a, const Point &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point vector_product(const Point &a, const Point &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point &a) {
  return std::sqrt(scalar(a, a));
}
// The direction of a vector across a unit vector, exactly across even if the vector nearly runs along that: any if
// nothing but roundings is left.
Point direction_across(const Point &axis, const Point &a) {
  Point off = plus(a, -scalar(a, axis), axis);
  if (!(length(off) > 1e-12 * length(a))) {
    off = vector_product(axis, std::abs(axis[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0});
  }
  off = plus({0, 0, 0}, 1 / length(off), off);
  off = plus(off, -scalar(off, axis), axis);
  return plus({0, 0, 0}, 1 / length(off), off);
}

}  // namespace

DistanceFromOutside::DistanceFromOutside(std::vector<ProbedBall> balls, Room room)
    : balls_(std::move(balls)), room_(std::move(room)) {
  for (size_t i = 0; i < balls_.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const Point to = plus(balls_[j].centre, -1, balls_[i].centre);
      const double d = length(to);
      const double along =
          (d * d + balls_[i].radius * balls_[i].radius - balls_[j].radius * balls_[j].radius) / (2 * d);
      const double square = balls_[i].radius * balls_[i].radius - along * along;
      if (!(d > 0) || !(square > 0)) continue;
      const Circle circle{plus(balls_[i].centre, along / d, to), plus({0, 0, 0}, 1 / d, to), std::sqrt(square)};
      circles_.push_back(circle);
      // Where it pierces further spheres: |m + rho e - c|^2 = r^2 for e in the circle's plane.
      for (size_t k = 0; k < j; ++k) {
        Point off = plus(balls_[k].centre, -1, circle.centre);
        off = plus(off, -scalar(off, circle.axis), circle.axis);
        const double h = length(off);
        const Point whole = plus(balls_[k].centre, -1, circle.centre);
        const double cosine =
            (scalar(whole, whole) + circle.radius * circle.radius - balls_[k].radius * balls_[k].radius) /
            (2 * circle.radius * h);
        if (!(h > 0) || !(std::abs(cosine) <= 1)) continue;
        const Point e = plus({0, 0, 0}, 1 / h, off);
        const Point f = vector_product(circle.axis, e);
        const double sine = std::sqrt(1 - cosine * cosine);
        for (const double side : {-1.0, 1.0}) {
          const Point v = plus(plus(circle.centre, circle.radius * cosine, e), side * circle.radius * sine, f);
          if (is_outside(v)) vertices_.push_back(v);
        }
      }
    }
  }
}

bool DistanceFromOutside::is_outside(const Point &y) const {
  return room_(y) && std::all_of(balls_.begin(), balls_.end(), [&](const ProbedBall &ball) {
           return length(plus(y, -1, ball.centre)) >= ball.radius - 1e-9;
         });
}

DistanceFromOutside::Nearest DistanceFromOutside::operator()(const Point &x) const {
  if (is_outside(x)) return {0, x};
  Nearest best{std::numeric_limits<double>::infinity(), x};
  const auto offer = [&](const Point &y, bool known_outside) {
    const double distance = length(plus(x, -1, y));
    if (distance < best.distance && (known_outside || is_outside(y))) best = {distance, y};
  };
  for (const Point &v : vertices_) offer(v, true);
  for (const Circle &circle : circles_) {
    // On the axis all points of the circle are as near; if others cover some of it, vertices are, too.
    const Point across = direction_across(circle.axis, plus(x, -1, circle.centre));
    offer(plus(circle.centre, circle.radius, across), false);
  }
  for (const ProbedBall &ball : balls_) {
    const Point off = plus(x, -1, ball.centre);
    const double h = length(off);
    if (h > 0) offer(plus(ball.centre, ball.radius / h, off), false);
  }
  return best;
}

AreaAndVolume excluded_surface_by_lines(const std::vector<ProbedBall> &balls, double probe, int lines,
                                        const Room &room) {
  const DistanceFromOutside distance(balls, room);
  AreaAndVolume sum;
  Point low{}, high{};
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::numeric_limits<double>::infinity();
    high[axis] = -low[axis];
    for (const ProbedBall &ball : balls) {
      low[axis] = std::min(low[axis], ball.centre[axis] - ball.radius);
      high[axis] = std::max(high[axis], ball.centre[axis] + ball.radius);
    }
  }
  const double least_step = 1e-3 * probe;
  for (size_t axis = 0; axis < 3; ++axis) {
    const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double du = (high[u] - low[u]) / lines, dv = (high[v] - low[v]) / lines;
    for (int i = 0; i < lines; ++i) {
      for (int j = 0; j < lines; ++j) {
        Point x{};
        // Not in step with the symmetries of a set.
        x[u] = low[u] + (i + 0.381966) * du;
        x[v] = low[v] + (j + 0.618034) * dv;
        const auto depth = [&](double at) {
          x[axis] = at;
          return distance(x).distance - probe;
        };
        // The distance changes by no more than the step.
        double at = low[axis] - 1, here = depth(at);
        while (at < high[axis] + 1) {
          const double next = at + std::max(std::abs(here), least_step);
          const double there = depth(next);
          if ((here >= 0) != (there >= 0)) {
            double a = at, b = next;
            for (int k = 0; k < 30; ++k) {
              const double middle = (a + b) / 2;
              ((depth(middle) >= 0) == (here >= 0) ? a : b) = middle;
            }
            x[axis] = b;
            const Point nearest = distance(x).point;
            sum.area += std::abs(x[axis] - nearest[axis]) / probe * du * dv;
            sum.volume += (here >= 0 ? b : -b) * du * dv / 3;
          }
          at = next;
          here = there;
        }
      }
    }
  }
  return sum;
}

}  // namespace oracle
