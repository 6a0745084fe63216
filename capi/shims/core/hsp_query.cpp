#include "hsp_model.hpp"
#include "model/queries.hpp"

using namespace hsp::capi;

namespace {

// Rounds the query ball, finds the balls that meet it, and reports them as all output arrays are reported.
int32_t ask(const hsp_model *model, const double *xyz, double radius, uint32_t *ids, uint32_t capacity,
            uint32_t *needed) {
  if (const int32_t status = check_results(model, xyz == nullptr || (ids == nullptr && capacity > 0)); status != HSP_OK)
    return status;
  hsp::QueryResult result{ids, capacity, 0};
  const hsp::Status status = hsp::find_balls(model->grid, xyz, radius, result);
  if (status != hsp::Status::ok) return to_c(status);
  return check_output(capacity, result.hits, needed);
}

}  // namespace

int32_t hsp_query_point(const hsp_model *model, const double *xyz, uint32_t *ids, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return ask(model, xyz, 0.0, ids, capacity, needed);
}

int32_t hsp_query_ball(const hsp_model *model, const double *xyz, double radius, uint32_t *ids, uint32_t capacity,
                       uint32_t *needed) {
  LibraryArithmetic arithmetic(radius);
  return ask(model, xyz, radius, ids, capacity, needed);
}

int32_t hsp_query_meets(const hsp_model *model, const double *xyz, double radius, uint32_t *meets) {
  LibraryArithmetic arithmetic(radius);
  if (const int32_t status = check_results(model, xyz == nullptr || meets == nullptr); status != HSP_OK) return status;
  hsp::LatticeQuery query;
  const hsp::Status status = hsp::round_query(model->balls(), xyz, radius, query);
  if (status != hsp::Status::ok) return to_c(status);
  *meets = hsp::any_ball_meets(model->grid, query) ? 1 : 0;
  return HSP_OK;
}
