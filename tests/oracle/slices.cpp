#include "slices.hpp"

#include <algorithm>
#include <array>

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

// Heights at which the slices change their structure. A change deep inside some ball is left out.
class BreakHeights {
 public:
  explicit BreakHeights(const std::vector<RealBall> &balls) : balls_(balls) {
    for (size_t i = 0; i < balls.size(); ++i) {
      add({balls[i].x, balls[i].y, balls[i].z + balls[i].radius});
      add({balls[i].x, balls[i].y, balls[i].z - balls[i].radius});
      for (size_t j = 0; j < i; ++j) {
        if (!add_circle(balls[i], balls[j])) continue;
        for (size_t k = 0; k < j; ++k) add_triple(balls[i], balls[j], balls[k]);
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

  // The highest and lowest points of the circle of two spheres; false if they have none.
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
    for (size_t k = 0; k < 3; ++k) foot[k] = (gu * vn[k] + gv * nu[k]) / n2;
    const Real height2 = a.radius * a.radius - dot(foot, foot);
    const Real tangency = 1e-12L * a.radius * a.radius;
    if (height2 < -tangency) return;
    const Real height = std::sqrt(std::max<Real>(0, height2) / n2);
    for (const Real side : {height, -height})
      add({a.x + foot[0] + side * n[0], a.y + foot[1] + side * n[1], a.z + foot[2] + side * n[2]});
    // If circles touch, the root magnifies the noise in height2: the true point is the foot.
    if (height2 < tangency) add({a.x + foot[0], a.y + foot[1], a.z + foot[2]});
  }

  const std::vector<RealBall> &balls_;
  std::vector<Real> heights_;
};

struct Disc {
  size_t ball = 0;
  Real x = 0;
  Real y = 0;
  Real radius2 = 0;
};

// A closed interval of angles within 0 .. 2 pi that another ball covers.
struct Covered {
  Real from = 0;
  Real to = 0;
  size_t by = 0;

  bool operator<(const Covered &other) const { return from < other.from; }
};

// Sorted intervals of a disc's circle in other discs; false if one of them covers the circle wholly.
bool find_covered(const std::vector<Disc> &discs, const Disc &disc, std::vector<Covered> &covered) {
  covered.clear();
  for (const Disc &other : discs) {
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
    covered.push_back({from, std::min(to, 2 * pi), other.ball});
    if (to > 2 * pi) covered.push_back({0, to - 2 * pi, other.ball});
  }
  std::sort(covered.begin(), covered.end());
  return true;
}

// The rest of a circle beside the sorted intervals.
std::vector<FreeSliceArc> free_arcs(const std::vector<Covered> &covered) {
  std::vector<FreeSliceArc> arcs;
  if (covered.empty()) return {{FreeSliceArc::none, 0, 2 * pi}};
  Covered last;  // the one that reaches farthest so far
  for (const Covered &next : covered) {
    if (next.from > last.to) arcs.push_back({last.by, last.to, next.from});
    if (next.to > last.to) last = next;
  }
  const bool at_start = !arcs.empty() && arcs.front().from == 0;
  if (last.to < 2 * pi) arcs.push_back({last.by, last.to, 2 * pi});
  // Angle 0 is no end of an arc: what starts there belongs to what comes before it.
  if (at_start && last.to < 2 * pi) {
    arcs.back().to += arcs.front().to;
    arcs.erase(arcs.begin());
  } else if (at_start) {
    arcs.front().after = last.by;
  }
  return arcs;
}

}  // namespace

std::vector<RealBall> real_balls(const Balls &balls) {
  std::vector<RealBall> result;
  for (const LatticeBall &ball : balls)
    result.push_back({static_cast<Real>(ball.x), static_cast<Real>(ball.y), static_cast<Real>(ball.z),
                      static_cast<Real>(ball.radius)});
  return result;
}

std::vector<RealBall> around_their_middle(const std::vector<RealBall> &balls) {
  Point middle = {0, 0, 0};
  for (const RealBall &ball : balls)
    for (size_t k = 0; k < 3; ++k)
      middle[k] += (k == 0 ? ball.x : k == 1 ? ball.y : ball.z) / static_cast<Real>(balls.size());
  std::vector<RealBall> moved = balls;
  for (RealBall &ball : moved) {
    ball.x -= middle[0];
    ball.y -= middle[1];
    ball.z -= middle[2];
  }
  return moved;
}

std::vector<Slab> slabs_of(const std::vector<RealBall> &balls) {
  if (balls.empty()) return {};
  const BreakHeights breaks(balls);
  const std::vector<Real> &heights = breaks.sorted();
  const Real negligible = 1e-17L * (heights.back() - heights.front());
  std::vector<Slab> slabs;
  for (size_t k = 1; k < heights.size(); ++k) {
    Slab slab = {heights[k - 1], heights[k], {}};
    if (slab.high - slab.low < negligible) continue;  // equal heights but for rounding
    for (size_t i = 0; i < balls.size(); ++i)
      if (balls[i].z - balls[i].radius < slab.high && balls[i].z + balls[i].radius > slab.low) slab.active.push_back(i);
    if (!slab.active.empty()) slabs.push_back(slab);
  }
  return slabs;
}

std::vector<SliceCircle> circles_of_slice(const std::vector<RealBall> &balls, const std::vector<size_t> &active,
                                          Real z) {
  std::vector<Disc> discs;
  for (const size_t i : active) {
    const Real above = z - balls[i].z;
    const Real radius2 = (balls[i].radius - above) * (balls[i].radius + above);
    if (radius2 > 0) discs.push_back({i, balls[i].x, balls[i].y, radius2});
  }
  std::vector<SliceCircle> circles;
  std::vector<Covered> covered;
  for (const Disc &disc : discs) {
    if (!find_covered(discs, disc, covered)) continue;
    std::vector<FreeSliceArc> arcs = free_arcs(covered);
    if (!arcs.empty()) circles.push_back({disc.ball, std::sqrt(disc.radius2), std::move(arcs)});
  }
  return circles;
}

}  // namespace oracle
