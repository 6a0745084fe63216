#include "excluded_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "random_numbers.hpp"

namespace oracle {
namespace {

using LongPoint = std::array<long double, 3>;

template <class Real>
std::array<Real, 3> plus(const std::array<Real, 3> &a, std::type_identity_t<Real> t, const std::array<Real, 3> &b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
template <class Real>
Real scalar(const std::array<Real, 3> &a, const std::array<Real, 3> &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Real>
std::array<Real, 3> vector_product(const std::array<Real, 3> &a, const std::array<Real, 3> &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class Real>
Real length(const std::array<Real, 3> &a) {
  return std::sqrt(scalar(a, a));
}
LongPoint to_long(const Point &a) {
  return {a[0], a[1], a[2]};
}
Point rounded(const LongPoint &a) {
  return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}
// The direction of a's part across the unit vector `axis`. It is orthogonal to the axis even if a nearly runs along it;
// if nothing but roundings is left of that part, it is any orthogonal direction.
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

// In long doubles: where spheres nearly touch, half of the digits of their common points are lost.
DistanceFromOutside::DistanceFromOutside(std::vector<ProbedBall> balls, Room room)
    : balls_(std::move(balls)), room_(std::move(room)) {
  for (size_t i = 0; i < balls_.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const LongPoint from = to_long(balls_[i].centre), to = plus(to_long(balls_[j].centre), -1, from);
      const long double d = length(to), r = balls_[i].radius, other = balls_[j].radius;
      const long double along = (d * d + (r - other) * (r + other)) / (2 * d), square = (r - along) * (r + along);
      if (!(d > 0) || !(square > 0)) continue;
      const LongPoint middle = plus(from, along / d, to), axis = plus({0, 0, 0}, 1 / d, to);
      const long double radius = std::sqrt(square);
      circles_.push_back({rounded(middle), rounded(axis), static_cast<double>(radius), i, j});
      // Where it pierces further spheres: |m + rho e - c|^2 = r^2 for e in the circle's plane.
      for (size_t k = 0; k < j; ++k) {
        const LongPoint whole = plus(to_long(balls_[k].centre), -1, middle);
        const LongPoint off = plus(whole, -scalar(whole, axis), axis);
        const long double h = length(off), third = balls_[k].radius;
        const long double cosine = (scalar(whole, whole) + square - third * third) / (2 * radius * h);
        // h is nothing but rounding for the same ball again and for a third ball on the circle's axis.
        if (!(h > 1e-14 * third) || !(std::abs(cosine) <= 1)) continue;
        const LongPoint e = plus({0, 0, 0}, 1 / h, off), f = vector_product(axis, e);
        const long double sine = std::sqrt((1 - cosine) * (1 + cosine));
        for (const long double side : {-1.0L, 1.0L}) {
          const Point v = rounded(plus(plus(middle, radius * cosine, e), side * radius * sine, f));
          if (is_outside(v, i, j, k)) vertices_.push_back(v);
        }
      }
    }
  }
}

bool DistanceFromOutside::is_outside(const Point &y, size_t i, size_t j, size_t k) const {
  for (size_t n = 0; n < balls_.size(); ++n) {
    if (n == i || n == j || n == k) continue;
    if (length(plus(y, -1, balls_[n].centre)) < balls_[n].radius * (1 - 1e-13)) return false;
  }
  return room_(y);
}

DistanceFromOutside::Nearest DistanceFromOutside::operator()(const Point &x) const {
  if (is_outside(x)) return {0, x};
  Nearest best{std::numeric_limits<double>::infinity(), x};
  const auto offer = [&](const Point &y, size_t i, size_t j) {
    const double distance = length(plus(x, -1, y));
    if (distance < best.distance && (i == none || is_outside(y, i, j))) best = {distance, y};
  };
  for (const Point &v : vertices_) offer(v, none, none);
  for (const Circle &circle : circles_) {
    // On the axis all points of the circle are as near; if others cover some of it, vertices are, too.
    const Point across = direction_across(circle.axis, plus(x, -1, circle.centre));
    offer(plus(circle.centre, circle.radius, across), circle.i, circle.j);
  }
  for (size_t i = 0; i < balls_.size(); ++i) {
    const Point off = plus(x, -1, balls_[i].centre);
    const double h = length(off);
    if (h > 0) offer(plus(balls_[i].centre, balls_[i].radius / h, off), i, none);
  }
  return best;
}

namespace {

std::array<Point, 2> box_around(const std::vector<ProbedBall> &balls) {
  Point low{}, high{};
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::numeric_limits<double>::infinity();
    high[axis] = -low[axis];
    for (const ProbedBall &ball : balls) {
      low[axis] = std::min(low[axis], ball.centre[axis] - ball.radius);
      high[axis] = std::max(high[axis], ball.centre[axis] + ball.radius);
    }
  }
  return {low, high};
}

}  // namespace

AreaAndVolume excluded_surface_by_lines(const std::vector<ProbedBall> &balls, double probe, int lines,
                                        const Room &room) {
  const DistanceFromOutside distance(balls, room);
  AreaAndVolume sum;
  const auto [low, high] = box_around(balls);
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

// The box is that of the balls without the probe: the solid does not reach beyond it.
double deviation_by_points(const std::vector<ProbedBall> &balls, double probe, double volume, int points,
                           uint64_t seed) {
  constexpr double fewest = 10;
  auto [low, high] = box_around(balls);
  double box = 1;
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] += probe;
    high[axis] -= probe;
    box *= high[axis] - low[axis];
  }
  const double expected = points * volume / box, others = points - expected;
  if (!(expected >= fewest && others >= fewest)) return -1;
  const DistanceFromOutside distance(balls);
  support::Random random(seed);
  double off = -expected;
  for (int k = 0; k < points; ++k) {
    Point x{};
    for (size_t axis = 0; axis < 3; ++axis) x[axis] = low[axis] + random.fraction() * (high[axis] - low[axis]);
    if (distance(x).distance >= probe) ++off;
  }
  return off * off * points / (expected * others);
}

}  // namespace oracle
