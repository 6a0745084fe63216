// Results from maps, of balls alone or of balls and sticks. A handle has has_map(), map(), bodies(), the number of
// bodies, and caller(id), the caller's number of a body.
#pragma once

#include "maps/edge_geometry.hpp"
#include "maps/face_pole.hpp"
#include "maps/map_queries.hpp"
#include "view_options.hpp"

namespace hsp::capi {

// Checks that a handle has a map. bad: whether an argument is bad.
template <class Handle>
int32_t check_map_of(const Handle *handle, bool bad) {
  const int32_t status = check_handle(handle, bad);
  return status == HSP_OK && !handle->has_map() ? HSP_E_STATE : status;
}

// Calls put(*handle, id, record) for the records first .. first + count - 1 of a list of the map.
template <class Handle, class List, class Record, class Put>
int32_t get_map_records(const Handle *handle, uint32_t first, uint32_t count, Record *out, List list, Put put) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_map_of(handle, out == nullptr && count > 0); status != HSP_OK) return status;
  const uint32_t there = (handle->map().*list).size();
  if (first > there || count > there - first) return HSP_E_ID;
  for (uint32_t k = 0; k < count; ++k) put(*handle, first + k, out[k]);
  return HSP_OK;
}

// Sets all fields of the info but the number of balls that are seen.
template <class Handle>
int32_t get_map_info(const Handle *handle, hsp_map_info *info) {
  if (const int32_t status = check_map_of(handle, info == nullptr); status != HSP_OK) return status;
  const auto &map = handle->map();
  const ViewLengths length{handle->balls().lattice};
  *info = {};
  put_frame(length, map.frame, *info);
  info->area = handle->balls().lattice.area(covered_area(map));
  info->perturbation = length(map.perturbation);
  info->vertices = map.vertices.size();
  info->edges = map.edges.size();
  info->faces = map.faces.size();
  info->components = map.components;
  return HSP_OK;
}

template <class Handle>
int32_t get_vertices(const Handle *handle, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  const auto put = [](const Handle &of, uint32_t id, hsp_map_vertex &record) {
    const ViewLengths length{of.balls().lattice};
    const MapVertex &vertex = of.map().vertices[id];
    record = {{length(vertex.x), length(vertex.y), length(vertex.z)},
              static_cast<uint32_t>(vertex.kind),
              vertex.leaving,
              {of.caller(vertex.body[0]), of.caller(vertex.body[1]), of.caller(vertex.body[2])},
              0};
  };
  return get_map_records(handle, first, count, out, &MapRecords::vertices, put);
}

template <class Handle>
int32_t get_edges(const Handle *handle, uint32_t first, uint32_t count, hsp_map_edge *out) {
  const auto put = [](const Handle &of, uint32_t id, hsp_map_edge &record) {
    const ViewLengths length{of.balls().lattice};
    const MapEdge &edge = of.map().edges[id];
    const EdgeCurve curve = curve_of(of.map(), id);
    record = {};
    length.point(curve.ellipse.centre, record.centre);
    length.point(curve.ellipse.first, record.first);
    length.point(curve.ellipse.second, record.second);
    record.from = curve.from;
    record.to = curve.to;
    record.ball[0] = of.caller(edge.is_silhouette() ? edge.body : edge.nearer);
    record.ball[1] = of.caller(edge.is_silhouette() ? no_id : edge.body);
    for (uint32_t side = 0; side < 2; ++side) {
      record.face[side] = of.map().face_of(2 * id + side);
      record.vertex[side] = edge.vertex[side];
      record.next[side] = of.map().half_edges[2 * id + side].next;
    }
  };
  return get_map_records(handle, first, count, out, &MapRecords::edges, put);
}

template <class Handle>
int32_t get_faces(const Handle *handle, uint32_t first, uint32_t count, hsp_map_face *out) {
  const auto put = [](const Handle &of, uint32_t id, hsp_map_face &record) {
    const MapFace &face = of.map().faces[id];
    uint32_t loops = 0;
    of.map().visit_loops(id, [&loops](uint32_t) { ++loops; });
    const uint32_t h = face.first_loop == no_id ? HSP_NONE : of.map().loops[face.first_loop].first_half_edge;
    record = {of.balls().lattice.area(face.area), of.caller(face.owner), h, loops, 0};
  };
  return get_map_records(handle, first, count, out, &MapRecords::faces, put);
}

// Writes the visible area of each body.
template <class Handle>
int32_t get_areas(const Handle *handle, double *area, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_map_of(handle, area == nullptr && capacity > 0); status != HSP_OK) return status;
  const uint32_t bodies = handle->bodies();
  if (const int32_t status = check_output(capacity, bodies, needed); status != HSP_OK) return status;
  const MapRecords &map = handle->map();
  sum_visible_areas(map, [&](uint32_t body) { return handle->caller(body); }, {area, bodies});
  for (uint32_t i = 0; i < bodies; ++i) area[i] = handle->balls().lattice.area(area[i]);
  return HSP_OK;
}

// Writes one directed edge of every loop around the faces of a ball or half of a stick.
template <class Handle>
int32_t get_outline(const Handle *handle, uint32_t body, uint32_t *h, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_map_of(handle, h == nullptr && capacity > 0); status != HSP_OK) return status;
  if (body >= handle->bodies()) return HSP_E_ID;
  const auto &map = handle->map();
  const auto visit = [&](auto take) {
    for (uint32_t f = handle->first_face_of(body); f != no_id; f = map.next_face_of(f)) {
      map.visit_loops(f, [&](uint32_t l) { take(map.loops[l].first_half_edge); });
    }
  };
  uint32_t count = 0;
  visit([&](uint32_t) { ++count; });
  const int32_t status = check_output(capacity, count, needed);
  if (status == HSP_OK) visit([&](uint32_t half_edge) { *h++ = half_edge; });
  return status;
}

template <class Handle>
int32_t get_point(const Handle *handle, uint32_t edge, double t, hsp_map_point *point) {
  LibraryArithmetic arithmetic(t);
  if (const int32_t status = check_map_of(handle, point == nullptr); status != HSP_OK) return status;
  const auto &map = handle->map();
  if (edge >= map.edges.size()) return HSP_E_ID;
  if (!is_finite(t)) return HSP_E_NOT_FINITE;
  const EdgeCurve curve = curve_of(map, edge);
  if (t < curve.from || t > curve.to) return HSP_E_RANGE;
  const ViewLengths length{handle->balls().lattice};
  const EdgePoint found = edge_point(map, edge, t);
  *point = {{length(found.x), length(found.y), length(found.z)}, {length(found.gap_left), length(found.gap_right)}};
  return HSP_OK;
}

template <class Handle>
int32_t get_pole(const Handle *handle, uint32_t face, hsp_map_pole *pole) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_map_of(handle, pole == nullptr); status != HSP_OK) return status;
  if (face == 0 || face >= handle->map().faces.size()) return HSP_E_ID;
  const ViewLengths length{handle->balls().lattice};
  const FacePole found = find_pole(handle->map(), face);
  *pole = {{length(found.x), length(found.y)}, length(found.radius), length(found.bound)};
  return HSP_OK;
}

// The body seen at a point.
template <class Handle>
int32_t pick(const Handle *handle, double x, double y, hsp_map_sight *sight) {
  LibraryArithmetic arithmetic(x, y);
  if (const int32_t status = check_map_of(handle, sight == nullptr); status != HSP_OK) return status;
  if (!is_finite(x) || !is_finite(y)) return HSP_E_NOT_FINITE;
  const exact::Lattice &lattice = handle->balls().lattice;
  const double at[2] = {lattice.steps(x), lattice.steps(y)};
  const MapSight seen = sight_at(handle->map(), handle->sight(), at[0], at[1]);
  *sight = {lattice.length(seen.depth), handle->caller(seen.ball), face_at(handle->map(), seen.ball, at[0], at[1])};
  return HSP_OK;
}

}  // namespace hsp::capi
