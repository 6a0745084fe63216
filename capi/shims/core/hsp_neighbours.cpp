// Queries for the neighbours of balls.
#include "caller_executor.hpp"
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

namespace {

// Lists the pairs of a model. Arguments have been checked.
int32_t list_pairs(const hsp_model *model, uint32_t flags, hsp::Patience patience, uint32_t *first, uint32_t *ids,
                   uint32_t capacity, uint32_t *needed) {
  const uint32_t n = model->balls().n;
  const hsp::PairRows rows = flags == HSP_PAIRS_ONCE ? hsp::PairRows::smaller : hsp::PairRows::both;
  const hsp::Span<uint32_t> begins(first, n + 1);
  const bool in_range = hsp::count_neighbours(model->grid, rows, begins, patience);
  if (!patience.allows(0)) return HSP_E_STOPPED;
  if (!in_range) return HSP_E_RANGE;
  const int32_t status = check_output(capacity, begins[n], needed);
  if (status != HSP_OK) return status;
  hsp::list_neighbours(model->grid, rows, begins, {ids, begins[n]}, hsp::most_cached_ids, patience);
  return patience.allows(0) ? HSP_OK : HSP_E_STOPPED;
}

int32_t check_pairs(const hsp_model *model, uint32_t flags, const uint32_t *first, const uint32_t *ids,
                    uint32_t capacity) {
  return check_results(model, (flags & ~HSP_PAIRS_ONCE) != 0 || first == nullptr || (ids == nullptr && capacity > 0));
}

}  // namespace

int32_t hsp_query_pairs(const hsp_model *model, uint32_t flags, uint32_t *first, uint32_t *ids, uint32_t capacity,
                        uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_pairs(model, flags, first, ids, capacity);
  return status == HSP_OK ? list_pairs(model, flags, hsp::Patience(), first, ids, capacity, needed) : status;
}

int32_t hsp_query_pairs_with(const hsp_model *model, const hsp_pairs_request *request, uint32_t *first, uint32_t *ids,
                             uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  hsp_pairs_request asked;
  Executor executor(arithmetic);
  if (const int32_t status = check_handle(model); status != HSP_OK) return status;
  int32_t status = read_request(request, asked);
  if (status == HSP_OK) status = executor.read(asked.executor);
  if (status == HSP_OK) status = check_pairs(model, asked.flags, first, ids, capacity);
  if (status != HSP_OK) return status;
  return list_pairs(model, asked.flags, hsp::Patience(&executor), first, ids, capacity, needed);
}
