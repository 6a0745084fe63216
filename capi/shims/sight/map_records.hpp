// How the records of maps come to the caller, of balls alone or with sticks: handle.caller(id) is the caller's number
// of whatever is seen.
#pragma once

#include "maps/edge_geometry.hpp"
#include "maps/face_pole.hpp"
#include "maps/map_queries.hpp"
#include "view_options.hpp"

namespace hsp::capi {

// All but how many balls are seen.
template <class Handle, class Map>
void put_map_info(const Handle &handle, const Map &map, hsp_map_info &info) {
  const ViewLengths length{handle.balls().lattice};
  info = {};
  put_frame(length, map.frame, info);
  info.area = handle.balls().lattice.area(covered_area(map));
  info.perturbation = length(map.perturbation);
  info.vertices = map.vertices.size();
  info.edges = map.edges.size();
  info.faces = map.faces.size();
  info.components = map.components;
}

template <class Handle, class Map>
void put_vertices(const Handle &handle, const Map &map, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  const ViewLengths length{handle.balls().lattice};
  for (uint32_t k = 0; k < count; ++k) {
    const MapVertex &vertex = map.vertices[first + k];
    out[k] = {{length(vertex.x), length(vertex.y), length(vertex.z)},
              static_cast<uint32_t>(vertex.kind),
              vertex.leaving,
              {handle.caller(vertex.body[0]), handle.caller(vertex.body[1]), handle.caller(vertex.body[2])},
              0};
  }
}

template <class Handle, class Map>
void put_edges(const Handle &handle, const Map &map, uint32_t first, uint32_t count, hsp_map_edge *out) {
  const ViewLengths length{handle.balls().lattice};
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t e = first + k;
    const MapEdge &edge = map.edges[e];
    const EdgeCurve curve = curve_of(map, e);
    hsp_map_edge record{};
    length.point(curve.ellipse.centre, record.centre);
    length.point(curve.ellipse.first, record.first);
    length.point(curve.ellipse.second, record.second);
    record.from = curve.from;
    record.to = curve.to;
    record.ball[0] = handle.caller(edge.is_silhouette() ? edge.body : edge.nearer);
    record.ball[1] = handle.caller(edge.is_silhouette() ? no_id : edge.body);
    for (uint32_t side = 0; side < 2; ++side) {
      record.face[side] = map.face_of(2 * e + side);
      record.vertex[side] = edge.vertex[side];
      record.next[side] = map.half_edges[2 * e + side].next;
    }
    out[k] = record;
  }
}

template <class Handle, class Map>
void put_faces(const Handle &handle, const Map &map, uint32_t first, uint32_t count, hsp_map_face *out) {
  for (uint32_t k = 0; k < count; ++k) {
    const MapFace &face = map.faces[first + k];
    uint32_t loops = 0;
    map.visit_loops(first + k, [&loops](uint32_t) { ++loops; });
    const uint32_t h = face.first_loop == no_id ? HSP_NONE : map.loops[face.first_loop].first_half_edge;
    out[k] = {handle.balls().lattice.area(face.area), handle.caller(face.owner), h, loops, 0};
  }
}

// area: of all that is seen, by the caller's numbers.
template <class Handle>
void put_areas(const Handle &handle, const MapRecords &map, Span<double> area) {
  sum_visible_areas(
      map, [&](uint32_t body) { return handle.caller(body); }, area);
  for (double &each : area) each = handle.balls().lattice.area(each);
}

// A directed edge of every loop around the faces from one on that are of the same ball or half of a stick.
template <class Map>
int32_t get_outline(const Map &map, uint32_t first_face, uint32_t *h, uint32_t capacity, uint32_t *needed) {
  const auto visit = [&](auto take) {
    for (uint32_t f = first_face; f != no_id; f = map.next_face_of(f)) {
      map.visit_loops(f, [&](uint32_t l) { take(map.loops[l].first_half_edge); });
    }
  };
  uint32_t count = 0;
  visit([&](uint32_t) { ++count; });
  const int32_t status = check_output(capacity, count, needed);
  if (status == HSP_OK) visit([&](uint32_t half_edge) { *h++ = half_edge; });
  return status;
}

template <class Handle, class Map>
int32_t get_point(const Handle &handle, const Map &map, uint32_t edge, double t, hsp_map_point &point) {
  if (edge >= map.edges.size()) return HSP_E_ID;
  if (!is_finite(t)) return HSP_E_NOT_FINITE;
  const EdgeCurve curve = curve_of(map, edge);
  if (t < curve.from || t > curve.to) return HSP_E_RANGE;
  const ViewLengths length{handle.balls().lattice};
  const EdgePoint found = edge_point(map, edge, t);
  point = {{length(found.x), length(found.y), length(found.z)}, {length(found.gap_left), length(found.gap_right)}};
  return HSP_OK;
}

template <class Handle, class Map>
int32_t get_pole(const Handle &handle, const Map &map, uint32_t face, hsp_map_pole &pole) {
  if (face == 0 || face >= map.faces.size()) return HSP_E_ID;
  const ViewLengths length{handle.balls().lattice};
  const FacePole found = find_pole(map, face);
  pole = {{length(found.x), length(found.y)}, length(found.radius), length(found.bound)};
  return HSP_OK;
}

// The body seen at a point, in lengths of the caller.
template <class Handle, class Map, class Sight>
void put_sight(const Handle &handle, const Map &map, const Sight &sight, double x, double y, hsp_map_sight &out) {
  const exact::Lattice &lattice = handle.balls().lattice;
  const double at[2] = {lattice.steps(x), lattice.steps(y)};
  const MapSight seen = sight_at(map, sight, at[0], at[1]);
  out = {lattice.length(seen.depth), handle.caller(seen.ball), face_at(map, seen.ball, at[0], at[1])};
}

}  // namespace hsp::capi
