// Questions to a finished map of any bodies: which body is seen at a point, how deep, and what an edge separates.
#pragma once

#include <limits>

#include "maps/scene_map.hpp"

namespace hsp {

// The body that is seen at a point of the view plane.
struct MapSight {
  uint32_t ball;  // no_id for the background
  double depth;   // view coordinate z of its front there
};

// Found from the fronts at the point, without the map's edges.
template <class Map, class Sight>
MapSight sight_at(const Map &map, const Sight &sight, double x, double y) {
  const uint32_t body = sight.highest_at(x, y, no_id).body;
  if (body == no_id) return {no_id, -std::numeric_limits<double>::infinity()};
  return {body, map.scene.front_at(body, x, y)};
}

// A point of an edge, and how far below it the visible surface is on either side; infinite if no body is there. On a
// contour the left gap is 0, on a crease both are.
struct EdgePoint {
  double x, y, z;
  double gap_left, gap_right;
};

// t: a parameter of the edge's curve.
template <class Map>
EdgePoint edge_point(const Map &map, uint32_t e, double t) {
  const MapEdge &edge = map.edges[e];
  const Vec3 at = map.scene.at(edge.body, edge.nearer, map.scene.edge_parameter(edge, t));
  if (!edge.is_silhouette()) return {at.x, at.y, at.z, 0.0, 0.0};
  const uint32_t behind = map.faces[map.face_of(2 * e + 1)].owner;
  const double gap =
      behind == no_id ? std::numeric_limits<double>::infinity() : at.z - map.scene.front_at(behind, at.x, at.y);
  return {at.x, at.y, at.z, 0.0, gap > 0.0 ? gap : 0.0};
}

// Sums the areas of each body's faces into area[caller(body)].
template <class Caller>
void sum_visible_areas(const MapRecords &map, Caller caller, Span<double> area) {
  for (double &sum : area) sum = 0.0;
  for (const MapFace &face : map.faces.items()) {
    if (face.owner != no_id) area[caller(face.owner)] += face.area;
  }
}

// The area that the bodies cover.
inline double covered_area(const MapRecords &map) {
  double sum = 0.0;
  for (const MapFace &face : map.faces.items()) sum += face.owner == no_id ? 0.0 : face.area;
  return sum;
}

// The half-edge before h around its face. It is found by a turn around the vertex that h leaves.
inline uint32_t previous_half_edge(const MapRecords &map, uint32_t h) {
  uint32_t leaving = h;
  for (;;) {
    const uint32_t arriving = leaving ^ 1U;
    leaving = map.half_edges[arriving].next;
    if (leaving == h) return arriving;
  }
}

// The next loop of the same face; after the last one the first.
inline uint32_t next_loop(const MapRecords &map, uint32_t loop) {
  const MapLoop &of = map.loops[loop];
  return of.next_of_face != no_id ? of.next_of_face : map.faces[of.face].first_loop;
}

}  // namespace hsp
