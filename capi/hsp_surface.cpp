#include "hsp_surface.hpp"
#include "surface/surface_areas.hpp"

using hsp::capi::is_live;

namespace {

// The limits that a program gives.
int32_t from_c(const hsp_surface_limits *given, hsp::SurfaceLimits &result) {
  hsp_surface_limits limits;
  if (!hsp::capi::read_struct(given, {}, limits)) return HSP_E_ARGUMENT;
  if (limits.vertices > HSP_MAX_BALLS || limits.neighbours > HSP_MAX_BALLS || limits.pieces > HSP_MAX_BALLS ||
      limits.arcs > HSP_MAX_BALLS || limits.cusped_circles > HSP_MAX_BALLS)
    return HSP_E_RANGE;
  result = {limits.vertices, limits.neighbours, limits.pieces, limits.arcs, limits.cusped_circles};
  return HSP_OK;
}

hsp_surface_limits to_c(const hsp::SurfaceLimits &limits) {
  return {sizeof(hsp_surface_limits), limits.vertices, limits.neighbours, limits.pieces, limits.arcs,
          limits.cusped_circles};
}

hsp_surface_totals to_c(const hsp::SurfaceMeasure &measure) {
  return {measure.area(), measure.volume, measure.convex, measure.saddle, measure.concave};
}

}  // namespace

int32_t hsp_surface_limits_init(hsp_surface_limits *limits, uint32_t struct_size, const hsp_boundary *boundary) {
  if (limits == nullptr || !is_live(boundary) || !hsp::capi::is_struct_size<hsp_surface_limits>(struct_size)) {
    return HSP_E_ARGUMENT;
  }
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::SurfaceLimits enough = hsp::default_surface_limits(structure.vertex_count(), structure.circle_count());
  hsp::capi::write_struct(to_c(enough), limits, struct_size);
  return HSP_OK;
}

int32_t hsp_surface_bytes(const hsp_surface_limits *limits, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  hsp::SurfaceLimits wanted;
  if (const int32_t status = from_c(limits, wanted); status != HSP_OK) return status;
  return hsp::capi::get_bytes<hsp_surface>(wanted, bytes);
}

int32_t hsp_surface_init(void *memory, size_t bytes, const hsp_surface_limits *limits, hsp_surface **surface) {
  if (memory == nullptr || surface == nullptr) return HSP_E_ARGUMENT;
  hsp::SurfaceLimits wanted;
  if (const int32_t status = from_c(limits, wanted); status != HSP_OK) return status;
  return hsp::capi::init(memory, bytes, wanted, surface);
}

int32_t hsp_surface_compute(hsp_surface *surface, const hsp_boundary *boundary, hsp_surface_limits *limits) {
  if (!is_live(surface)) return HSP_E_ARGUMENT;
  surface->complete = false;
  if (!is_live(boundary) || !hsp::capi::may_write(limits)) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::Status status = surface->builder.build(boundary->balls(), boundary->structure());
  surface->boundary = boundary;
  surface->computed = boundary->computed;
  constexpr hsp_surface_limits (*convert)(const hsp::SurfaceLimits &) = to_c;
  return hsp::capi::finish<convert>(*surface, status, limits);
}

int32_t hsp_surface_get_counts(const hsp_surface *surface, hsp_surface_counts *counts) {
  if (!is_live(surface) || counts == nullptr) return HSP_E_ARGUMENT;
  if (!surface->has_results()) return HSP_E_STATE;
  const hsp::Boundary &boundary = surface->boundary->structure();
  const hsp::SurfaceCounts &found = surface->builder.surface().counts();
  *counts = {boundary.face_count(),   boundary.arc_count() + boundary.circle_count(),
             boundary.vertex_count(), found.cusped_arcs,
             found.cut_patches,       found.hidden_patches,
             found.rounded_patches,   found.joints.open};
  return HSP_OK;
}

int32_t hsp_surface_measure(const hsp_surface *surface, hsp_surface_totals *totals, hsp_surface_totals *balls,
                            uint32_t capacity, uint32_t *needed) {
  if (!is_live(surface)) return HSP_E_ARGUMENT;
  if (!surface->has_results()) return HSP_E_STATE;
  const hsp_boundary &boundary = *surface->boundary;
  const hsp::CubeGrid &grid = boundary.model->grid;
  if (!hsp::capi::fits(balls != nullptr, capacity, grid.balls().n, needed)) return HSP_E_CAPACITY;
  const hsp::SurfaceMeasure total = hsp::measure_surface(grid, boundary.structure(), surface->builder.surface(),
                                                         [balls](uint32_t i, const hsp::SurfaceMeasure &measure) {
                                                           if (balls != nullptr) balls[i] = to_c(measure);
                                                         });
  if (totals != nullptr) *totals = to_c(total);
  return HSP_OK;
}
