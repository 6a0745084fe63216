#include <limits>

#include "hsp_sticks.hpp"
#include "map_records.hpp"
#include "maps/face_nesting.hpp"

using hsp::capi::check_handle;

namespace {

bool has_map(const hsp_sticks *sticks) {
  return sticks->has_results() && sticks->regions().exist;
}

// As hsp::capi::check_range, of `there` records.
int32_t check_records(const hsp_sticks *sticks, uint32_t first, uint32_t count, const void *out, uint32_t there) {
  if (out == nullptr && count > 0) return HSP_E_ARGUMENT;
  if (!has_map(sticks)) return HSP_E_STATE;
  return first > there || count > there - first ? HSP_E_ID : HSP_OK;
}

}  // namespace

int32_t hsp_sticks_get_map_info(const hsp_sticks *sticks, hsp_map_info *info) {
  if (const int32_t status = check_handle(sticks, info == nullptr); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  const hsp::StickRegions &of = sticks->regions();
  hsp::capi::put_map_info(*sticks, of, *info);
  for (uint32_t p = 0; p < of.paths; ++p) info->balls += of.scene.is_ball(of.owner_of(p)) ? 1U : 0U;
  return HSP_OK;
}

int32_t hsp_sticks_get_vertices(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  if (const int32_t status = check_handle(sticks); status != HSP_OK) return status;
  const hsp::StickRegions &of = sticks->regions();
  const int32_t status = check_records(sticks, first, count, out, of.vertices.size());
  if (status == HSP_OK) hsp::capi::put_vertices(*sticks, of, first, count, out);
  return status;
}

int32_t hsp_sticks_get_edges(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_edge *out) {
  if (const int32_t status = check_handle(sticks); status != HSP_OK) return status;
  const hsp::StickRegions &of = sticks->regions();
  const int32_t status = check_records(sticks, first, count, out, of.edges.size());
  if (status == HSP_OK) hsp::capi::put_edges(*sticks, of, first, count, out);
  return status;
}

int32_t hsp_sticks_get_faces(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_face *out) {
  if (const int32_t status = check_handle(sticks); status != HSP_OK) return status;
  const hsp::StickRegions &of = sticks->regions();
  const int32_t status = check_records(sticks, first, count, out, of.faces.size());
  if (status == HSP_OK) hsp::capi::put_faces(*sticks, of, first, count, out);
  return status;
}

int32_t hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_handle(sticks, needed == nullptr || (area == nullptr && capacity > 0));
      status != HSP_OK)
    return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  const uint32_t bodies = sticks->bodies();
  const int32_t status = hsp::capi::check_output(area, capacity, bodies, needed);
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < bodies; ++k) area[k] = 0.0;
  for (const hsp::MapFace &face : sticks->regions().faces.items()) {
    if (face.owner != hsp::no_id) area[sticks->caller(face.owner)] += face.area;
  }
  for (uint32_t k = 0; k < bodies; ++k) area[k] = sticks->balls().lattice.area(area[k]);
  return HSP_OK;
}

int32_t hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight) {
  if (const int32_t status = check_handle(sticks, sight == nullptr); status != HSP_OK) return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  if (!hsp::is_finite(x) || !hsp::is_finite(y)) return HSP_E_NOT_FINITE;
  const hsp::exact::Lattice &lattice = sticks->balls().lattice;
  const double at[2] = {lattice.steps(x), lattice.steps(y)};
  const hsp::BodySight::Highest seen = sticks->builder.highest_at(at[0], at[1]);
  const double depth = seen.body == hsp::no_id ? -std::numeric_limits<double>::infinity() : lattice.length(seen.z);
  *sight = {depth, sticks->caller(seen.body), hsp::face_at(sticks->regions(), seen.body, at[0], at[1])};
  return HSP_OK;
}

int32_t hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id) {
  if (const int32_t status = check_handle(sticks, invariant == nullptr || id == nullptr); status != HSP_OK)
    return status;
  if (!has_map(sticks)) return HSP_E_STATE;
  return hsp::capi::report(hsp::check_regions(sticks->regions(), sticks->builder.more_scratch()), invariant, id);
}
