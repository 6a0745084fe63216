
#include "hsp_sticks.hpp"
#include "map_records.hpp"
#include "maps/map_check.hpp"

using hsp::capi::check_handle;
using hsp::capi::LibraryArithmetic;

namespace {

bool has_map(const hsp_sticks *sticks) {
  return sticks->has_results() && sticks->map().exist;
}

// As hsp::capi::check_range, of `there` records.
int32_t check_records(const hsp_sticks *sticks, uint32_t first, uint32_t count, const void *out, uint32_t there) {
  if (out == nullptr && count > 0) return HSP_E_ARGUMENT;
  if (!has_map(sticks)) return HSP_E_STATE;
  return first > there || count > there - first ? HSP_E_ID : HSP_OK;
}

}  // namespace

int32_t hsp_sticks_get_map_info(const hsp_sticks *sticks, hsp_map_info *info) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(sticks, info == nullptr); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  const hsp::StickMap &of = sticks->map();
  hsp::capi::put_map_info(*sticks, of, *info);
  for (uint32_t p = 0; p < of.owners; ++p) info->balls += of.scene.is_ball(of.owner_of(p)) ? 1U : 0U;
  return HSP_OK;
}

int32_t hsp_sticks_get_vertices(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(sticks); status != HSP_OK) return status;
  const hsp::StickMap &of = sticks->map();
  const int32_t status = check_records(sticks, first, count, out, of.vertices.size());
  if (status == HSP_OK) hsp::capi::put_vertices(*sticks, of, first, count, out);
  return status;
}

int32_t hsp_sticks_get_edges(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_edge *out) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(sticks); status != HSP_OK) return status;
  const hsp::StickMap &of = sticks->map();
  const int32_t status = check_records(sticks, first, count, out, of.edges.size());
  if (status == HSP_OK) hsp::capi::put_edges(*sticks, of, first, count, out);
  return status;
}

int32_t hsp_sticks_get_faces(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_face *out) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(sticks); status != HSP_OK) return status;
  const hsp::StickMap &of = sticks->map();
  const int32_t status = check_records(sticks, first, count, out, of.faces.size());
  if (status == HSP_OK) hsp::capi::put_faces(*sticks, of, first, count, out);
  return status;
}

int32_t hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(sticks, area == nullptr && capacity > 0); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  const uint32_t bodies = sticks->bodies();
  const int32_t status = hsp::capi::check_output(capacity, bodies, needed);
  if (status != HSP_OK) return status;
  hsp::capi::put_areas(*sticks, sticks->map(), {area, bodies});
  return HSP_OK;
}

int32_t hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight) {
  LibraryArithmetic arithmetic(x, y);
  if (const int32_t status = check_handle(sticks, sight == nullptr); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  if (!hsp::is_finite(x) || !hsp::is_finite(y)) return HSP_E_NOT_FINITE;
  hsp::capi::put_sight(*sticks, sticks->map(), sticks->builder.sight(), x, y, *sight);
  return HSP_OK;
}

int32_t hsp_sticks_get_outline(const hsp_sticks *sticks, uint32_t ball, uint32_t *h, uint32_t capacity,
                               uint32_t *needed) {
  if (const int32_t status = check_handle(sticks, h == nullptr && capacity > 0); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  if (ball >= sticks->bodies()) return HSP_E_ID;
  return hsp::capi::get_outline(sticks->map(), sticks->map().first_face_of(sticks->body(ball)), h, capacity, needed);
}

int32_t hsp_sticks_get_point(const hsp_sticks *sticks, uint32_t edge, double t, hsp_map_point *point) {
  LibraryArithmetic arithmetic(t);
  if (const int32_t status = check_handle(sticks, point == nullptr); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  return hsp::capi::get_point(*sticks, sticks->map(), edge, t, *point);
}

int32_t hsp_sticks_get_pole(const hsp_sticks *sticks, uint32_t face, hsp_map_pole *pole) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(sticks, pole == nullptr); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  return hsp::capi::get_pole(*sticks, sticks->map(), face, *pole);
}

int32_t hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(sticks, invariant == nullptr || id == nullptr); status != HSP_OK)
    return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  return hsp::capi::report(hsp::check_map(sticks->map(), sticks->builder.more_scratch()), invariant, id);
}
