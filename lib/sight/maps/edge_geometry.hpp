// Edges of a map in the view plane, as parts of ellipses: where they end, what area they enclose, which point or hole
// they surround.
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

// A part of an ellipse. A line is an ellipse without a minor axis, from one end of the major axis to the other.
struct EdgeCurve {
  EdgeEllipse ellipse;
  double from, to;
};

template <class Map>
EdgeCurve curve_of(const Map &map, uint32_t e) {
  const MapEdge &edge = map.edges[e];
  return map.scene.curve(edge, map.vertices[edge.vertex[0]], map.vertices[edge.vertex[1]]);
}

// A bound for the uncertainty of positions: that of points of nearly touching curves, and of a T, which may miss its
// arc by 2^-24.
template <class Map>
double position_tolerance(const Map &map) {
  return 0x1p-18 * map.scene.largest();
}

// The distance in the view plane from end 0 or 1 of an edge's curve to the vertex at that end.
template <class Map>
double end_off_vertex(const Map &map, uint32_t e, uint32_t end) {
  const MapEdge &edge = map.edges[e];
  const Vec3 point = map.scene.at(edge.body, edge.nearer, end == 0 ? edge.from : edge.to);
  const MapVertex &vertex = map.vertices[edge.vertex[end]];
  const double dx = point.x - vertex.x;
  const double dy = point.y - vertex.y;
  return std::sqrt(dx * dx + dy * dy);
}

// The first edge with an end that is not at its vertex; no_id if there is none. When spheres nearly coincide, the
// circle of two of them is badly determined, and may be far from a vertex that the third sphere gives. has_end(h):
// whether to look at the end from which half-edge h leaves.
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

// The first half-edge whose side is wrong; no_id if there is none. A side shows a body, which shall have a front at the
// middle of the edge, and none nearer than the edge. When many curves meet in one point, labels may agree about loops
// that do not exist.
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

// Twice the area that half-edge 2e sweeps about the point (x, y) (Green's formula).
template <class Map>
double swept_twice(const Map &map, uint32_t e, double x, double y) {
  const EdgeCurve curve = curve_of(map, e);
  const EdgeEllipse &ellipse = curve.ellipse;
  const MapVertex &v = map.vertices[map.edges[e].vertex[0]];
  const MapVertex &w = map.vertices[map.edges[e].vertex[1]];
  return (ellipse.centre[0] - x) * (w.y - v.y) - (ellipse.centre[1] - y) * (w.x - v.x) +
         (ellipse.first[0] * ellipse.second[1] - ellipse.first[1] * ellipse.second[0]) * (curve.to - curve.from);
}

// The direction of all rays: the cosine and sine of 1, a direction in which no two vertices of a scene made by hand
// lie. By rounding a vertex on a ray may count for both of its edges, or for none.
inline constexpr double ray_x = 0.5403023058681398, ray_y = 0.8414709848078965;

// How far a vector leads to the left of the ray.
inline double beside_ray(const double v[2]) {
  return ray_x * v[1] - ray_y * v[0];
}

// How often an edge meets the ray from (x, y).
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

// The rest tells which loops of a map lie within which: the face at a point, and the holes of faces. For maps of any
// bodies.

// Whether a loop surrounds a point, by the parity of its crossings with a ray.
template <class Map>
bool surrounds(const Map &map, uint32_t loop, double x, double y) {
  uint32_t count = 0;
  map.visit_loop(loop, [&](uint32_t h) { count += crossings(curve_of(map, h / 2), x, y); });
  return count % 2 == 1;
}

// The face at a point at which `owner` is seen, one of the faces of that body. no_id if edges are so close that
// rounding decides. A point lies in a face if it is within the outer loop and in no hole. That is tested by parity:
// then an odd number of the face's loops surrounds the point. O(edges of the outer loops and holes of the owner's
// faces).
template <class Map>
uint32_t face_at(const Map &map, uint32_t owner, double x, double y) {
  // Beyond all balls there is one face, and differences to such points may overflow.
  constexpr double beyond = 0x1p53;
  if (!(std::fabs(x) < beyond && std::fabs(y) < beyond)) return map.first_face_of(no_id);
  uint32_t found = no_id;
  for (uint32_t f = map.first_face_of(owner); f != no_id; f = map.next_face_of(f)) {
    uint32_t count = f == 0 ? 1 : 0;  // the unbounded face has no outer loop: 1 stands for it
    map.visit_loops(f, [&](uint32_t l) { count += surrounds(map, l, x, y) ? 1U : 0U; });
    if (count % 2 == 0) continue;
    if (found != no_id) return no_id;
    found = f;
  }
  return found;
}

// The innermost face of the hole's owner whose outer loop has the hole inside; if there is none, no_id, or for the
// background the unbounded face.
template <class Map>
uint32_t face_around(const Map &map, const MapLoop &hole) {
  const bool background = hole.owner == no_id;
  const uint32_t first = map.first_face_of(hole.owner);
  if (first == no_id || map.next_face_of(first) == no_id) return first;
  // A point of the hole's edge such that a vertex on the ray from it is not likely.
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

// Assigns holes to faces, after outer loops have theirs. False if a hole has no face around it, or if the number of
// holes is not that of the connected parts of the edges: each part is surrounded by one hole.
template <class Map>
bool add_holes(Map &map) {
  uint32_t holes = 0;
  for (uint32_t l = 0; l < map.loops.size(); ++l) {
    MapLoop &loop = map.loops[l];
    if (loop.area > 0.0) continue;
    ++holes;
    loop.face = face_around(map, loop);
    if (loop.face == no_id) return false;
    // Inserted behind the outer loop, before the other holes.
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
