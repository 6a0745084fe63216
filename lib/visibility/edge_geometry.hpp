// Edges of a map in the view plane: points of an ellipse.
#pragma once

#include "visibility/curves.hpp"
#include "visibility/visibility_map.hpp"

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

// Where an edge begins and ends by its parameters.
inline void put_ends(const VisibilityMap &map, uint32_t e, double ends[2][2]) {
  const EdgeCurve curve = curve_of(map, e);
  for (int end = 0; end < 2; ++end) {
    const SinCos t = sin_cos(end == 0 ? curve.from : curve.to);
    ends[end][0] = curve.ellipse.x(t);
    ends[end][1] = curve.ellipse.y(t);
  }
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
