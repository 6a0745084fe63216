// Queries for the neighbours of balls.
#include "hsp_model.hpp"
#include "model/neighbour_lists.hpp"
#include "model/queries.hpp"

using namespace hsp::capi;

int32_t hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity,
                             uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(model, ids == nullptr && capacity > 0); status != HSP_OK) return status;
  if (ball >= model->balls().n) return HSP_E_ID;
  hsp::QueryResult result{ids, capacity, 0};
  hsp::find_neighbours(model->grid, model->grid.grid_index(ball), result);
  return check_output(capacity, result.hits, needed);
}

int32_t hsp_query_pairs(const hsp_model *model, uint32_t flags, uint32_t *first, uint32_t *ids, uint32_t capacity,
                        uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status =
          check_results(model, (flags & ~HSP_PAIRS_ONCE) != 0 || first == nullptr || (ids == nullptr && capacity > 0));
      status != HSP_OK)
    return status;
  const uint32_t n = model->balls().n;
  const hsp::PairRows rows = flags == HSP_PAIRS_ONCE ? hsp::PairRows::smaller : hsp::PairRows::both;
  const hsp::Span<uint32_t> begins(first, n + 1);
  if (!hsp::count_neighbours(model->grid, rows, begins)) return HSP_E_RANGE;
  const int32_t status = check_output(capacity, begins[n], needed);
  if (status == HSP_OK) hsp::list_neighbours(model->grid, rows, begins, {ids, begins[n]});
  return status;
}
