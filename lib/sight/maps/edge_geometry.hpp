// Edges of a map in the view plane: points of an ellipse.
#pragma once

#include "maps/curves.hpp"
#include "maps/visibility_map.hpp"

namespace hsp {

// The points centre + cos t first + sin t second.
struct EdgeEllipse {
  double centre[2], first[2], second[2];

  EdgeEllipse(const Vec3 &m, const Vec3 &a, const Vec3 &b) { set(m, a, b); }
  EdgeEllipse(Span<const SeenBall> balls, const MapEdge &edge) {
    const SeenBall &ball = balls[edge.ball];
    if (edge.is_silhouette()) {
      set({ball.x, ball.y, ball.z}, {ball.r, 0.0, 0.0}, {0.0, ball.r, 0.0});
      return;
    }
    const Crease crease(ball, balls[edge.nearer]);
    set(crease.m, crease.rho * crease.a, crease.rho * crease.b);
  }

  double x(const SinCos &t) const { return centre[0] + first[0] * t.cosine + second[0] * t.sine; }
  double y(const SinCos &t) const { return centre[1] + first[1] * t.cosine + second[1] * t.sine; }
  double longer_half_axis() const {
    const double one = first[0] * first[0] + first[1] * first[1];
    const double other = second[0] * second[0] + second[1] * second[1];
    return std::sqrt(one > other ? one : other);
  }

 private:
  void set(const Vec3 &m, const Vec3 &a, const Vec3 &b) {
    centre[0] = m.x;
    centre[1] = m.y;
    first[0] = a.x;
    first[1] = a.y;
    second[0] = b.x;
    second[1] = b.y;
  }
};

// An edge in the view plane, of a map of whatever bodies: what is said of maps here and in face_nesting.hpp and
// map_laws.hpp holds for all that have curve_of.
struct EdgeCurve {
  EdgeEllipse ellipse;
  double from, to;
};

inline EdgeCurve curve_of(const VisibilityMap &map, uint32_t e) {
  const MapEdge &edge = map.edges[e];
  return {EdgeEllipse(map.balls, edge), edge.from, edge.to};
}

// How many bodies a map is of, and the largest radius, or how long the longest stick is.
struct MapBodies {
  uint32_t count;
  double largest;

  void cover(double length) { largest = length > largest ? length : largest; }
  // Points of nearly touching curves are that uncertain, and a T may miss its arc by 2^-24.
  double position_tolerance() const { return 0x1p-18 * largest; }
};

inline MapBodies bodies_of(const VisibilityMap &map) {
  MapBodies bodies{map.balls.size(), 0.0};
  for (const SeenBall &ball : map.balls) bodies.cover(ball.r);
  return bodies;
}

// The point of an edge at a parameter.
inline Vec3 point_of(const VisibilityMap &map, const MapEdge &edge, double t) {
  const SeenBall &ball = map.balls[edge.ball];
  return edge.is_silhouette() ? silhouette_point(ball, t) : Crease(ball, map.balls[edge.nearer]).at(t);
}

// The middle of an edge on a silhouette, from its vertices where that is well conditioned, as it is sooner found so.
inline Vec3 middle_of(const VisibilityMap &map, const MapEdge &edge) {
  const SeenBall &ball = map.balls[edge.ball];
  const MapVertex &v = map.vertices[edge.vertex[0]];
  const MapVertex &w = map.vertices[edge.vertex[1]];
  const double x = v.x + w.x - 2 * ball.x;
  const double y = v.y + w.y - 2 * ball.y;
  const double squared = x * x + y * y;
  if (squared < 0x1p-8 * ball.r * ball.r) return silhouette_point(ball, 0.5 * (edge.from + edge.to));
  const double part = (edge.to - edge.from > pi ? -ball.r : ball.r) / std::sqrt(squared);
  return {ball.x + part * x, ball.y + part * y, ball.z};
}

// What a ball takes of the view plane, grown by a margin.
inline double silhouette_area(const SeenBall &ball, double margin) {
  return pi * (ball.r + margin) * (ball.r + margin);
}
inline double silhouette_area(const VisibilityMap &map, uint32_t ball, double margin) {
  return silhouette_area(map.balls[ball], margin);
}

// Whether a point is no farther than a margin outside the disc of a ball, and behind its front.
inline bool may_be_seen(const SeenBall &ball, const Vec3 &p, double margin) {
  const double dx = p.x - ball.x;
  const double dy = p.y - ball.y;
  const double outer = ball.r + margin;
  return dx * dx + dy * dy <= outer * outer && depth_behind(p, ball) <= outer * outer - ball.r * ball.r;
}
inline bool may_be_seen(const VisibilityMap &map, uint32_t ball, const Vec3 &p, double margin) {
  return may_be_seen(map.balls[ball], p, margin);
}

// Twice the area that an edge sweeps about a point, as of half-edge 2e (Green's formula).
template <class Map>
double swept_twice(const Map &map, uint32_t e, double x, double y) {
  const EdgeCurve curve = curve_of(map, e);
  const EdgeEllipse &ellipse = curve.ellipse;
  const MapVertex &v = map.vertices[map.edges[e].vertex[0]];
  const MapVertex &w = map.vertices[map.edges[e].vertex[1]];
  return (ellipse.centre[0] - x) * (w.y - v.y) - (ellipse.centre[1] - y) * (w.x - v.x) +
         (ellipse.first[0] * ellipse.second[1] - ellipse.first[1] * ellipse.second[0]) * (curve.to - curve.from);
}

// How often an edge meets a ray from (x, y), the same for all edges.
uint32_t crossings(const EdgeCurve &curve, double x, double y);

}  // namespace hsp
