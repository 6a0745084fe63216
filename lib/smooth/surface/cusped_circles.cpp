#include "surface/cusped_circles.hpp"

#include "core/first_index.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {
namespace {

bool circle_has_cusps(const ActualBalls &actual, uint32_t a, uint32_t b) {
  // Most circles are larger than the probe for certain: rho^2 = R^2 - h^2 in doubles, with an error of some e (U +
  // R^2).
  const BallSet &balls = actual.balls();
  const double p = static_cast<double>(balls.probe_steps);
  const Vec3 v = balls.difference(a, b);
  const double U = dot(v, v);
  const double R = balls.r[a];
  const double twice = U + (R - balls.r[b]) * (R + balls.r[b]);  // 2 d h
  const double margin = 0x1p-40 * (U + R * R + balls.r[b] * balls.r[b]);
  if (R * R - p * p > 0.25 * twice * (twice / U) + margin) return false;
  return actual.has_cusps(a, b);
}

}  // namespace

void CuspedCircles::clear() {
  circle_.clear();
  first_whole_ = 0;
  arcs_ = 0;
}

// The half-edges of a ball are sorted by their circles: those of one circle are neighbours.
bool CuspedCircles::find(const ActualBalls &actual, Patience &patience) {
  const Boundary &boundary = actual.boundary();
  clear();
  for (uint32_t i = 0; i < actual.balls().n; ++i) {
    if (!patience.allows(100 + 100 * uint64_t{boundary.half_edges(i).size()})) return false;
    uint32_t last = no_id;
    bool has = false;
    for (const uint32_t e : boundary.half_edges(i)) {
      const uint32_t other = boundary.half_edge(e).circle;
      if (other < i) continue;
      if (other != last) {
        has = circle_has_cusps(actual, i, other);
        if (has) circle_.push({{i, other}, LoopElement::arc(e), arcs_});
      }
      last = other;
      if (has) ++arcs_;
    }
  }
  first_whole_ = clamped_count(required());
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    if (!patience.allows(100)) return false;
    const CircleRecord &circle = boundary.circle(c);
    if (circle_has_cusps(actual, circle.ball[0], circle.ball[1]))
      circle_.push({{circle.ball[0], circle.ball[1]}, LoopElement::circle({c, 0}), saddles()});
  }
  return true;
}

uint32_t CuspedCircles::of_arc(uint32_t a, uint32_t b) const {
  const uint32_t low = a < b ? a : b, high = a < b ? b : a;
  const uint32_t first = first_index(0, first_whole_, [this, low](uint32_t k) { return circle_[k].ball[0] >= low; });
  for (uint32_t k = first; k < first_whole_ && circle_[k].ball[0] == low; ++k) {
    if (circle_[k].ball[1] == high) return k;
  }
  return no_id;
}

LoopElement CuspedCircles::element(uint32_t saddle_number) const {
  const auto is_behind = [this, saddle_number](uint32_t k) { return circle_[k].first_saddle > saddle_number; };
  const Circle &circle = circle_[first_index(1, count(), is_behind) - 1];
  return LoopElement::from_code(circle.element.code() + (saddle_number - circle.first_saddle));
}

uint32_t CuspedCircles::of_circle(uint32_t circle) const {
  const LoopElement element = LoopElement::circle({circle, 0});
  const auto is_from_there = [this, element](uint32_t k) { return circle_[k].element.code() >= element.code(); };
  const uint32_t k = first_index(first_whole_, count(), is_from_there);
  return begins_with(k, element) ? k : no_id;
}

}  // namespace hsp
