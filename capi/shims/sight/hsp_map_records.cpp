#include "hsp_map.hpp"
#include "map_records.hpp"

using namespace hsp::capi;

namespace {}  // namespace

int32_t hsp_map_get_info(const hsp_map *map, hsp_map_info *info) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(map, info == nullptr); status != HSP_OK) return status;
  put_map_info(*map, map->structure(), *info);
  info->balls = map->structure().owners;
  return HSP_OK;
}

int32_t hsp_map_get_vertices(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_range(map, first, count, out, [](const hsp_map &m) { return m.structure().vertices.size(); });
  if (status == HSP_OK) put_vertices(*map, map->structure(), first, count, out);
  return status;
}

int32_t hsp_map_get_edges(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_edge *out) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_range(map, first, count, out, [](const hsp_map &m) { return m.structure().edges.size(); });
  if (status == HSP_OK) put_edges(*map, map->structure(), first, count, out);
  return status;
}

int32_t hsp_map_get_faces(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_face *out) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_range(map, first, count, out, [](const hsp_map &m) { return m.structure().faces.size(); });
  if (status == HSP_OK) put_faces(*map, map->structure(), first, count, out);
  return status;
}

int32_t hsp_map_get_areas(const hsp_map *map, double *area, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(map, area, capacity, needed, [](const hsp_map &m) { return m.balls().n; });
  if (status != HSP_OK) return status;
  put_areas(*map, map->structure(), {area, map->balls().n});
  return HSP_OK;
}

int32_t hsp_map_get_outline(const hsp_map *map, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_results(map, h == nullptr && capacity > 0); status != HSP_OK) return status;
  if (ball >= map->balls().n) return HSP_E_ID;
  const uint32_t first = map->structure().first_face[map->model->grid.grid_index(ball)];
  return get_outline(map->structure(), first, h, capacity, needed);
}
