#include "hsp_sticks.hpp"
#include "map_records.hpp"
#include "maps/map_check.hpp"

using namespace hsp::capi;

int32_t hsp_sticks_get_map_info(const hsp_sticks *sticks, hsp_map_info *info) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = get_map_info(sticks, info); status != HSP_OK) return status;
  const hsp::StickMap &of = sticks->map();
  for (uint32_t p = 0; p < of.owners; ++p) info->balls += of.scene.is_ball(of.owner_of(p)) ? 1U : 0U;
  return HSP_OK;
}

int32_t hsp_sticks_get_vertices(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  return get_vertices(sticks, first, count, out);
}

int32_t hsp_sticks_get_edges(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_edge *out) {
  return get_edges(sticks, first, count, out);
}

int32_t hsp_sticks_get_faces(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_face *out) {
  return get_faces(sticks, first, count, out);
}

int32_t hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity, uint32_t *needed) {
  return get_areas(sticks, area, capacity, needed);
}

int32_t hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight) {
  return pick(sticks, x, y, sight);
}

int32_t hsp_sticks_get_outline(const hsp_sticks *sticks, uint32_t ball, uint32_t *h, uint32_t capacity,
                               uint32_t *needed) {
  return get_outline(sticks, ball, h, capacity, needed);
}

int32_t hsp_sticks_get_point(const hsp_sticks *sticks, uint32_t edge, double t, hsp_map_point *point) {
  return get_point(sticks, edge, t, point);
}

int32_t hsp_sticks_get_pole(const hsp_sticks *sticks, uint32_t face, hsp_map_pole *pole) {
  return get_pole(sticks, face, pole);
}

int32_t hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_map_of(sticks, invariant == nullptr || id == nullptr);
  if (status != HSP_OK) return status;
  return report(hsp::check_map(sticks->map(), sticks->builder.more_scratch()), invariant, id);
}
