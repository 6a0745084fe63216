#include "hsp_map.hpp"
#include "map_records.hpp"

using namespace hsp::capi;

int32_t hsp_map_get_info(const hsp_map *map, hsp_map_info *info) {
  LibraryArithmetic arithmetic;
  const int32_t status = get_map_info(map, info);
  if (status == HSP_OK) info->balls = map->map().owners;
  return status;
}

int32_t hsp_map_get_vertices(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  return get_vertices(map, first, count, out);
}

int32_t hsp_map_get_edges(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_edge *out) {
  return get_edges(map, first, count, out);
}

int32_t hsp_map_get_faces(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_face *out) {
  return get_faces(map, first, count, out);
}

int32_t hsp_map_get_areas(const hsp_map *map, double *area, uint32_t capacity, uint32_t *needed) {
  return get_areas(map, area, capacity, needed);
}

int32_t hsp_map_get_outline(const hsp_map *map, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t *needed) {
  return get_outline(map, ball, h, capacity, needed);
}

int32_t hsp_map_pick(const hsp_map *map, double x, double y, hsp_map_sight *sight) {
  return pick(map, x, y, sight);
}

int32_t hsp_map_get_point(const hsp_map *map, uint32_t edge, double t, hsp_map_point *point) {
  return get_point(map, edge, t, point);
}

int32_t hsp_map_get_pole(const hsp_map *map, uint32_t face, hsp_map_pole *pole) {
  return get_pole(map, face, pole);
}
