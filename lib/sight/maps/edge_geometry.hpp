// Edges of a map in the view plane: points of an ellipse.
#pragma once

#include <cmath>
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

// How far one end of an edge's curve is from its vertex.
template <class Map>
double end_off_vertex(const Map &map, uint32_t e, uint32_t end) {
  const MapEdge &edge = map.edges[e];
  const Vec3 point = map.scene.at(edge.body, edge.nearer, end == 0 ? edge.from : edge.to);
  const MapVertex &vertex = map.vertices[edge.vertex[end]];
  const double dx = point.x - vertex.x;
  const double dy = point.y - vertex.y;
  return std::sqrt(dx * dx + dy * dy);
}

// The first edge that ends elsewhere than at its vertices; no_id if there is none. Where spheres nearly coincide, two
// of them leave little of where their curve is, and it may be elsewhere than a third curve through its end says.
// has_end(half-edge that leaves there): whether an end is looked at.
template <class Map, class HasEnd>
uint32_t first_edge_off_its_vertices(const Map &map, HasEnd has_end) {
  const double tolerance = position_tolerance(map);
  for (uint32_t e = 0; e < map.edges.size(); ++e) {
    for (uint32_t end = 0; end < 2; ++end) {
      if (has_end(2 * e + end) && !(end_off_vertex(map, e, end) <= tolerance)) return e;
    }
  }
  return no_id;
}

// The first half-edge with something on its side that has no front at the middle of its edge, or has one before it;
// no_id if there is none. Where many curves tie in a point labels may agree about loops that are not there.
template <class Map>
uint32_t first_side_without_front(const Map &map) {
  const double margin = position_tolerance(map);
  for (uint32_t e = 0; e < map.edges.size(); ++e) {
    const MapEdge &edge = map.edges[e];
    const Vec3 middle = map.scene.at(edge.body, edge.nearer, 0.5 * (edge.from + edge.to));
    for (const uint32_t h : {2 * e, 2 * e + 1}) {
      const uint32_t owner = map.loops[map.half_edges[h].loop].owner;
      if (owner != no_id && !map.scene.may_be_seen(owner, middle, margin)) return h;
    }
  }
  return no_id;
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

// The cosine and sine of 1: a direction in which no two vertices of a scene that was made up by hand lie. A vertex on
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

// Which loops of a map lie within which: the face at a point, and the holes of faces. For maps of whatever bodies, with
// records like those of a VisibilityMap.

// Whether a loop runs around a point, by the parity of its crossings with a ray.
template <class Map>
bool surrounds(const Map &map, uint32_t loop, double x, double y) {
  uint32_t count = 0;
  map.visit_loop(loop, [&](uint32_t h) { count += crossings(curve_of(map, h / 2), x, y); });
  return count % 2 == 1;
}

// The face at a point where `owner` is seen, among the faces of that: O(edges of their outer loops and holes). no_id
// where edges are so close that roundings decide. A point lies in a face if it is within its outer loop and within none
// of its holes: of all these an odd number surrounds it from the face's side.
template <class Map>
uint32_t face_at(const Map &map, uint32_t owner, double x, double y) {
  // Beyond all balls there is one face, and differences to such points may overflow.
  constexpr double beyond = 0x1p53;
  if (!(std::fabs(x) < beyond && std::fabs(y) < beyond)) return map.first_face_of(no_id);
  uint32_t found = no_id;
  for (uint32_t f = map.first_face_of(owner); f != no_id; f = map.next_face_of(f)) {
    uint32_t count = f == 0 ? 1 : 0;  // around the unbounded face is nothing
    map.visit_loops(f, [&](uint32_t l) { count += surrounds(map, l, x, y) ? 1U : 0U; });
    if (count % 2 == 0) continue;
    if (found != no_id) return no_id;
    found = f;
  }
  return found;
}

// The innermost face of the hole's owner with the hole within its outer loop, the unbounded face if there is none.
template <class Map>
uint32_t face_around(const Map &map, const MapLoop &hole) {
  const bool background = hole.owner == no_id;
  const uint32_t first = map.first_face_of(hole.owner);
  if (first == no_id || map.next_face_of(first) == no_id) return first;
  // Some point that is not likely to be in the direction of a vertex.
  const EdgeCurve curve = curve_of(map, hole.first_half_edge / 2);
  const SinCos t = sin_cos(curve.from + 0.3819660112501051 * (curve.to - curve.from));
  uint32_t best = background ? 0 : no_id;
  double smallest = 0.0;
  for (uint32_t f = background ? map.next_face_of(0) : first; f != no_id; f = map.next_face_of(f)) {
    const double area = map.loops[map.faces[f].first_loop].area;
    if (area <= -hole.area || (smallest > 0.0 && area >= smallest)) continue;
    if (!surrounds(map, map.faces[f].first_loop, curve.ellipse.x(t), curve.ellipse.y(t))) continue;
    best = f;
    smallest = area;
  }
  return best;
}

// Gives the holes to faces, once outer loops have theirs. False if there is none for one of them, or if there are more
// or fewer holes than connected parts of the edges: around each there is one.
template <class Map>
bool add_holes(Map &map) {
  uint32_t holes = 0;
  for (uint32_t l = 0; l < map.loops.size(); ++l) {
    MapLoop &loop = map.loops[l];
    if (loop.area > 0.0) continue;
    ++holes;
    loop.face = face_around(map, loop);
    if (loop.face == no_id) return false;
    // Behind the outer loop, before the holes that are there.
    MapFace &face = map.faces[loop.face];
    if (face.first_loop == no_id || loop.face == 0) {
      loop.next_of_face = face.first_loop;
      face.first_loop = l;
    } else {
      MapLoop &outer = map.loops[face.first_loop];
      loop.next_of_face = outer.next_of_face;
      outer.next_of_face = l;
    }
    if (loop.face != 0) face.area += loop.area;
  }
  return holes == map.components;
}

}  // namespace hsp
