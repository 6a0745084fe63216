#include "hsp_map.hpp"
#include "view_options.hpp"
#include "visibility/edge_geometry.hpp"
#include "visibility/map_queries.hpp"

using hsp::capi::is_live;

namespace {

using hsp::capi::check_range;
using hsp::capi::check_request;
using hsp::capi::ViewLengths;

hsp_map_edge to_c(const hsp_map &map, uint32_t e) {
  const hsp::VisibilityMap &of = map.structure();
  const hsp::MapEdge &edge = of.edges[e];
  const hsp::EdgeEllipse ellipse(of.balls, edge);
  const ViewLengths length{map.balls().lattice};
  hsp_map_edge out{};
  length.point(ellipse.centre, out.centre);
  length.point(ellipse.first, out.first);
  length.point(ellipse.second, out.second);
  out.from = edge.from;
  out.to = edge.to;
  out.ball[0] = map.caller(edge.is_silhouette() ? edge.ball : edge.nearer);
  out.ball[1] = map.caller(edge.is_silhouette() ? hsp::no_id : edge.ball);
  for (uint32_t side = 0; side < 2; ++side) {
    out.face[side] = of.face_of(2 * e + side);
    out.vertex[side] = edge.vertex[side];
    out.next[side] = of.half_edges[2 * e + side].next;
  }
  return out;
}

hsp_map_face to_c(const hsp_map &map, const hsp::MapFace &face) {
  const hsp::VisibilityMap &of = map.structure();
  uint32_t loops = 0;
  for (uint32_t l = face.first_loop; l != hsp::no_id; l = of.loops[l].next_of_face) ++loops;
  const uint32_t h = face.first_loop == hsp::no_id ? HSP_NONE : of.loops[face.first_loop].first_half_edge;
  return {map.balls().lattice.area(face.area), map.caller(face.owner), h, loops, 0};
}

}  // namespace

int32_t hsp_map_get_info(const hsp_map *map, hsp_map_info *info) {
  if (!is_live(map) || info == nullptr) return HSP_E_ARGUMENT;
  if (!map->has_results()) return HSP_E_STATE;
  const hsp::VisibilityMap &of = map->structure();
  const ViewLengths length{map->balls().lattice};
  *info = {};
  hsp::capi::put_frame(length, of.frame, *info);
  info->area = map->balls().lattice.area(hsp::covered_area(of));
  info->perturbation = length(of.perturbation);
  info->vertices = of.vertices.size();
  info->edges = of.edges.size();
  info->faces = of.faces.size();
  info->components = of.components;
  info->balls = of.owners;
  return HSP_OK;
}

int32_t hsp_map_get_vertices(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  const int32_t status =
      check_range(map, first, count, out, [](const hsp_map &m) { return m.structure().vertices.size(); });
  if (status != HSP_OK) return status;
  const ViewLengths length{map->balls().lattice};
  for (uint32_t k = 0; k < count; ++k) {
    const hsp::MapVertex &vertex = map->structure().vertices[first + k];
    out[k] = {{length(vertex.x), length(vertex.y), length(vertex.z)},
              static_cast<uint32_t>(vertex.kind),
              vertex.leaving,
              {map->caller(vertex.ball[0]), map->caller(vertex.ball[1]), map->caller(vertex.ball[2])},
              0};
  }
  return HSP_OK;
}

int32_t hsp_map_get_edges(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_edge *out) {
  const int32_t status =
      check_range(map, first, count, out, [](const hsp_map &m) { return m.structure().edges.size(); });
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < count; ++k) out[k] = to_c(*map, first + k);
  return HSP_OK;
}

int32_t hsp_map_get_faces(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_face *out) {
  const int32_t status =
      check_range(map, first, count, out, [](const hsp_map &m) { return m.structure().faces.size(); });
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < count; ++k) out[k] = to_c(*map, map->structure().faces[first + k]);
  return HSP_OK;
}

int32_t hsp_map_get_areas(const hsp_map *map, double *area, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(map, area, capacity, needed, [](const hsp_map &m) { return m.balls().n; });
  if (status != HSP_OK) return status;
  const hsp::BallSet &balls = map->balls();
  hsp::sum_visible_areas(map->structure(), balls.caller, {area, balls.n});
  for (uint32_t i = 0; i < balls.n; ++i) area[i] = balls.lattice.area(area[i]);
  return HSP_OK;
}

int32_t hsp_map_get_outline(const hsp_map *map, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t *needed) {
  if (!is_live(map) || needed == nullptr || (h == nullptr && capacity > 0)) return HSP_E_ARGUMENT;
  if (!map->has_results()) return HSP_E_STATE;
  if (ball >= map->balls().n) return HSP_E_ID;
  const hsp::VisibilityMap &of = map->structure();
  const auto visit = [&](auto take) {
    const uint32_t first = of.first_face[map->model->grid.grid_index(ball)];
    for (uint32_t f = first; f != hsp::no_id; f = of.next_face_of(f)) {
      for (uint32_t l = of.faces[f].first_loop; l != hsp::no_id; l = of.loops[l].next_of_face) take(of.loops[l]);
    }
  };
  uint32_t count = 0;
  visit([&](const hsp::MapLoop &) { ++count; });
  const int32_t status = hsp::capi::check_output(h, capacity, count, needed);
  if (status != HSP_OK) return status;
  uint32_t *next = h;
  visit([&](const hsp::MapLoop &loop) { *next++ = loop.first_half_edge; });
  return HSP_OK;
}
