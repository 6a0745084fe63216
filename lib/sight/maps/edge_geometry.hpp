// Edges of a map in the view plane: points of an ellipse.
#pragma once

#include <initializer_list>

#include "core/elementary.hpp"
#include "core/vec3.hpp"
#include "maps/scene_map.hpp"

namespace hsp {

// The points centre + cos t first + sin t second.
struct EdgeEllipse {
  double centre[2], first[2], second[2];

  EdgeEllipse(const Vec3 &m, const Vec3 &a, const Vec3 &b) : centre{m.x, m.y}, first{a.x, a.y}, second{b.x, b.y} {}

  double x(const SinCos &t) const { return centre[0] + first[0] * t.cosine + second[0] * t.sine; }
  double y(const SinCos &t) const { return centre[1] + first[1] * t.cosine + second[1] * t.sine; }
  double longer_half_axis() const {
    const double one = first[0] * first[0] + first[1] * first[1];
    const double other = second[0] * second[0] + second[1] * second[1];
    return std::sqrt(one > other ? one : other);
  }
};

// Lines are ellipses without a minor axis, from one end of the major one to the other.
struct EdgeCurve {
  EdgeEllipse ellipse;
  double from, to;
};

template <class Map>
EdgeCurve curve_of(const Map &map, uint32_t e) {
  const MapEdge &edge = map.edges[e];
  return map.scene.curve(edge, map.vertices[edge.vertex[0]], map.vertices[edge.vertex[1]]);
}

// Points of nearly touching curves are that uncertain, and a T may miss its arc by 2^-24.
template <class Map>
double position_tolerance(const Map &map) {
  return 0x1p-18 * map.scene.largest();
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

// The cosine and sine of 1: a direction in which no two vertices of a scene that somebody has made up lie. A vertex on
// the ray may count for both of its edges, or for none, as roundings will have it.
inline constexpr double ray_x = 0.5403023058681398, ray_y = 0.8414709848078965;

inline double beside_ray(const double v[2]) {
  return ray_x * v[1] - ray_y * v[0];
}

// How often an edge meets a ray from (x, y), the same for all edges.
inline uint32_t crossings(const EdgeCurve &curve, double x, double y) {
  const EdgeEllipse &ellipse = curve.ellipse;
  const double c = beside_ray(ellipse.first);
  const double s = beside_ray(ellipse.second);
  const double from_centre[2] = {x - ellipse.centre[0], y - ellipse.centre[1]};
  const double height = beside_ray(from_centre);
  const double squared = c * c + s * s - height * height;
  if (squared <= 0.0) return 0;
  const double middle = arc_tangent(s, c);
  const double half = arc_tangent(std::sqrt(squared), height);
  uint32_t count = 0;
  for (double t : {middle - half, middle + half}) {
    while (t >= curve.from) t -= 2 * pi;
    while (t < curve.from) t += 2 * pi;
    if (t >= curve.to) continue;
    const SinCos at = sin_cos(t);
    if (ray_x * (ellipse.x(at) - x) + ray_y * (ellipse.y(at) - y) > 0.0) ++count;
  }
  return count;
}

}  // namespace hsp
