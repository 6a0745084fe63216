#include "hsp_map.hpp"

#include "compute_from.hpp"
#include "maps/map_check.hpp"
#include "maps/map_queries.hpp"
#include "view_options.hpp"

using namespace hsp::capi;

namespace {

// The map in which h is a directed edge; null if there is none.
const hsp::VisibilityMap *map_with(const hsp_map *map, uint32_t h) {
  if (!is_live(map) || !map->has_results()) return nullptr;
  return h < map->map().half_edges.size() ? &map->map() : nullptr;
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
  const hsp::VisibilityMap *const of = map_with(map, h);
  return of == nullptr ? HSP_NONE : of->half_edges[h].next;
}

uint32_t hsp_map_previous(const hsp_map *map, uint32_t h) {
  const hsp::VisibilityMap *const of = map_with(map, h);
  return of == nullptr ? HSP_NONE : hsp::previous_half_edge(*of, h);
}

uint32_t hsp_map_next_loop(const hsp_map *map, uint32_t h) {
  const hsp::VisibilityMap *const of = map_with(map, h);
  return of == nullptr ? HSP_NONE : of->loops[hsp::next_loop(*of, of->half_edges[h].loop)].first_half_edge;
}

uint32_t hsp_map_origin(const hsp_map *map, uint32_t h) {
  const hsp::VisibilityMap *const of = map_with(map, h);
  return of == nullptr ? HSP_NONE : of->origin(h);
}

uint32_t hsp_map_left(const hsp_map *map, uint32_t h) {
  const hsp::VisibilityMap *const of = map_with(map, h);
  return of == nullptr ? HSP_NONE : of->face_of(h);
}

int32_t hsp_map_check(hsp_map *map, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(map, invariant == nullptr || id == nullptr); status != HSP_OK) return status;
  return report(hsp::check_map(map->map(), map->builder.scratch()), invariant, id);
}
