#include "hsp_map.hpp"

#include "compute_from.hpp"
#include "maps/map_check.hpp"
#include "maps/map_queries.hpp"
#include "view_options.hpp"

using namespace hsp::capi;

namespace {

// step(map), or HSP_NONE if there are no results or no directed edge h.
template <class Step>
uint32_t take_step(const hsp_map *map, uint32_t h, Step step) {
  if (!is_live(map) || !map->has_results()) return HSP_NONE;
  return h < map->map().half_edges.size() ? step(map->map()) : HSP_NONE;
}

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_map);

int32_t hsp_map_compute(hsp_map *map, const hsp_model *model, const hsp_view_options *options, hsp_map_limits *limits) {
  return compute_from(map, model, options, limits, [&](const hsp_view_options &wanted, Executor &executor) {
    map->model.set(model);
    return map->builder.build(model->grid, direction_of(wanted), hsp::Patience(&executor));
  });
}

uint32_t hsp_map_next(const hsp_map *map, uint32_t h) {
  return take_step(map, h, [h](const hsp::VisibilityMap &of) { return of.half_edges[h].next; });
}

uint32_t hsp_map_previous(const hsp_map *map, uint32_t h) {
  return take_step(map, h, [h](const hsp::VisibilityMap &of) { return hsp::previous_half_edge(of, h); });
}

uint32_t hsp_map_next_loop(const hsp_map *map, uint32_t h) {
  return take_step(map, h, [h](const hsp::VisibilityMap &of) {
    return of.loops[hsp::next_loop(of, of.half_edges[h].loop)].first_half_edge;
  });
}

uint32_t hsp_map_origin(const hsp_map *map, uint32_t h) {
  return take_step(map, h, [h](const hsp::VisibilityMap &of) { return of.origin(h); });
}

uint32_t hsp_map_left(const hsp_map *map, uint32_t h) {
  return take_step(map, h, [h](const hsp::VisibilityMap &of) { return of.face_of(h); });
}

int32_t hsp_map_check(hsp_map *map, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(map, invariant == nullptr || id == nullptr); status != HSP_OK) return status;
  return report(hsp::check_map(map->map(), map->builder.scratch()), invariant, id);
}
