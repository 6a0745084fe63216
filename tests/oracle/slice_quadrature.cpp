#include "slice_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace oracle {
namespace {

using Real = long double;
using Point = std::array<Real, 3>;

constexpr Real pi = std::numbers::pi_v<Real>;

Real dot(const Point &a, const Point &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point &a, const Point &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point between(const RealBall &a, const RealBall &b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}

/// Heights at which the slices change their structure, as far as they are not deep inside some ball.
class BreakHeights {
 public:
  explicit BreakHeights(const std::vector<RealBall> &balls) : balls_(balls) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
      add({balls[i].x, balls[i].y, balls[i].z + balls[i].radius});
      add({balls[i].x, balls[i].y, balls[i].z - balls[i].radius});
      for (std::size_t j = 0; j < i; ++j) {
        if (!add_circle(balls[i], balls[j])) continue;
        for (std::size_t k = 0; k < j; ++k) add_triple(balls[i], balls[j], balls[k]);
      }
    }
    std::sort(heights_.begin(), heights_.end());
  }

  [[nodiscard]] const std::vector<Real> &sorted() const { return heights_; }

 private:
  void add(const Point &point) {
    // An event well inside a ball moves nothing on the boundary of the union.
    for (const RealBall &ball : balls_) {
      const Point d = {point[0] - ball.x, point[1] - ball.y, point[2] - ball.z};
      if (dot(d, d) < ball.radius * ball.radius * (1 - 1e-6L)) return;
    }
    heights_.push_back(point[2]);
  }

  /// The highest and lowest points of the circle of two spheres; false if they have none.
  bool add_circle(const RealBall &a, const RealBall &b) {
    const Point v = between(a, b);
    const Real d2 = dot(v, v);
    const Real sum = a.radius + b.radius;
    const Real difference = a.radius - b.radius;
    if (d2 == 0 || d2 > sum * sum || d2 < difference * difference) return false;
    const Real share = (d2 + sum * difference) / (2 * d2);
    const Real circle_radius2 = std::max<Real>(0, a.radius * a.radius - share * share * d2);
    const Real flat2 = v[0] * v[0] + v[1] * v[1];
    const Point centre = {a.x + share * v[0], a.y + share * v[1], a.z + share * v[2]};
    if (flat2 == 0) {
      heights_.push_back(centre[2]);  // a horizontal circle
      return true;
    }
    // Up along the plane of the circle: e_z minus its part along v, of length sqrt(flat2 / d2).
    const Real scale = std::sqrt(circle_radius2 * flat2 / d2);
    const Point up = {-v[0] * v[2] / flat2, -v[1] * v[2] / flat2, 1};
    for (const Real side : {scale, -scale}) add({centre[0] + side * up[0], centre[1] + side * up[1], centre[2] + side});
    return true;
  }

  void add_triple(const RealBall &a, const RealBall &b, const RealBall &c) {
    const Point u = between(a, b);
    const Point v = between(a, c);
    const Point n = cross(u, v);
    const Real n2 = dot(n, n);
    if (n2 <= 1e-30L * dot(u, u) * dot(v, v)) return;
    const Real gu = (dot(u, u) + a.radius * a.radius - b.radius * b.radius) / 2;
    const Real gv = (dot(v, v) + a.radius * a.radius - c.radius * c.radius) / 2;
    const Point nu = cross(n, u);
    const Point vn = cross(v, n);
    Point foot;
    for (std::size_t k = 0; k < 3; ++k) foot[k] = (gu * vn[k] + gv * nu[k]) / n2;
    const Real height2 = a.radius * a.radius - dot(foot, foot);
    const Real tangency = 1e-12L * a.radius * a.radius;
    if (height2 < -tangency) return;
    const Real height = std::sqrt(std::max<Real>(0, height2) / n2);
    for (const Real side : {height, -height})
      add({a.x + foot[0] + side * n[0], a.y + foot[1] + side * n[1], a.z + foot[2] + side * n[2]});
    // Where circles touch, the root makes noise of height2 large: the true height is the foot's.
    if (height2 < tangency) add({a.x + foot[0], a.y + foot[1], a.z + foot[2]});
  }

  const std::vector<RealBall> &balls_;
  std::vector<Real> heights_;
};

struct Disc {
  std::size_t ball = 0;
  Real x = 0;
  Real y = 0;
  Real radius2 = 0;
};

/// What is free of the discs of one slice.
class Slice {
 public:
  Slice(const std::vector<RealBall> &balls, const std::vector<std::size_t> &active, Real z) {
    for (const std::size_t i : active) {
      const Real above = z - balls[i].z;
      const Real radius2 = (balls[i].radius - above) * (balls[i].radius + above);
      if (radius2 > 0) discs_.push_back({i, balls[i].x, balls[i].y, radius2});
    }
  }

  /// Adds weight * radius * free angle to the balls' areas and weight * area of the union to the volume.
  void add_to(SliceMeasures &measures, const std::vector<RealBall> &balls, Real weight) {
    for (const Disc &disc : discs_) {
      if (!find_covered(disc)) continue;
      const Real radius = std::sqrt(disc.radius2);
      Real angle = 0;
      Real twice_area = 0;
      const auto free_arc = [&](Real from, Real to) {
        angle += to - from;
        twice_area += disc.radius2 * (to - from) +
                      radius * (disc.x * (std::sin(to) - std::sin(from)) - disc.y * (std::cos(to) - std::cos(from)));
      };
      Real reached = 0;
      for (const auto &[from, to] : covered_) {
        if (from > reached) free_arc(reached, from);
        reached = std::max(reached, to);
      }
      if (reached < 2 * pi) free_arc(reached, 2 * pi);
      measures.ball_area[disc.ball] += weight * balls[disc.ball].radius * angle;
      measures.volume += weight * twice_area / 2;
    }
  }

 private:
  /// Sorted angular intervals of a disc's circle in other discs; false if the circle is covered wholly.
  bool find_covered(const Disc &disc) {
    covered_.clear();
    for (const Disc &other : discs_) {
      if (other.ball == disc.ball) continue;
      const Real dx = other.x - disc.x;
      const Real dy = other.y - disc.y;
      const Real d2 = dx * dx + dy * dy;
      // On the circle the other disc covers the angles up to theta from its direction,
      // cos theta = cosine / (2 d radius).
      const Real cosine = d2 + disc.radius2 - other.radius2;
      const Real sine2 = 4 * d2 * disc.radius2 - cosine * cosine;
      if (sine2 <= 0) {
        if (cosine < 0 || (d2 == 0 && cosine == 0 && other.ball < disc.ball)) return false;
        continue;
      }
      const Real theta = std::atan2(std::sqrt(sine2), cosine);
      Real from = std::atan2(dy, dx) - theta;
      if (from < 0) from += 2 * pi;
      const Real to = from + 2 * theta;
      covered_.push_back({from, std::min(to, 2 * pi)});
      if (to > 2 * pi) covered_.push_back({0, to - 2 * pi});
    }
    std::sort(covered_.begin(), covered_.end());
    return true;
  }

  std::vector<Disc> discs_;
  std::vector<std::array<Real, 2>> covered_;
};

}  // namespace

SliceMeasures measure_by_slices(const std::vector<RealBall> &balls, Real step) {
  SliceMeasures measures;
  measures.ball_area.assign(balls.size(), 0);
  if (balls.empty()) return measures;

  // Around the middle: the terms of Green's formula stay as small as the set.
  std::vector<RealBall> moved = balls;
  Point middle = {0, 0, 0};
  for (const RealBall &ball : balls)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += (k == 0 ? ball.x : k == 1 ? ball.y : ball.z) / static_cast<Real>(balls.size());
  for (RealBall &ball : moved) {
    ball.x -= middle[0];
    ball.y -= middle[1];
    ball.z -= middle[2];
  }

  const BreakHeights breaks(moved);
  const std::vector<Real> &heights = breaks.sorted();
  const Real negligible = 1e-17L * (heights.back() - heights.front());
  for (std::size_t k = 1; k < heights.size(); ++k) {
    const Real low = heights[k - 1];
    const Real high = heights[k];
    const Real half = (high - low) / 2;
    if (high - low < negligible) continue;  // equal heights but for rounding
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < moved.size(); ++i)
      if (moved[i].z - moved[i].radius < high && moved[i].z + moved[i].radius > low) active.push_back(i);
    if (active.empty()) continue;
    // z = middle + half tanh(pi/2 sinh t); beyond |t| = 3.4 the weights are below 1e-19.
    const int nodes = static_cast<int>(std::floor(3.4L / step));
    for (int node = -nodes; node <= nodes; ++node) {
      const Real t = step * static_cast<Real>(node);
      const Real s = pi / 2 * std::sinh(t);
      const Real to_end = half * 2 / (1 + std::exp(2 * std::abs(s)));  // distance from the nearer end
      const Real z = node < 0 ? low + to_end : high - to_end;
      const Real weight = half * step * (pi / 2) * std::cosh(t) / (std::cosh(s) * std::cosh(s));
      Slice(moved, active, z).add_to(measures, moved, weight);
    }
  }
  for (const Real area : measures.ball_area) measures.area += area;
  return measures;
}

std::vector<RealBall> real_balls(const Balls &balls) {
  std::vector<RealBall> result;
  for (const LatticeBall &ball : balls)
    result.push_back({static_cast<Real>(ball.x), static_cast<Real>(ball.y), static_cast<Real>(ball.z),
                      static_cast<Real>(ball.radius)});
  return result;
}

}  // namespace oracle
