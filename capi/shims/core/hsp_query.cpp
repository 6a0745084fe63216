#include "hsp_model.hpp"
#include "model/neighbour_lists.hpp"
#include "model/queries.hpp"
#include "model/ray_query.hpp"

using hsp::capi::check_results;
using hsp::capi::LibraryArithmetic;

namespace {

// Rounds the query, asks, and reports as every output array is reported.
int32_t ask(const hsp_model *model, const double *xyz, double radius, uint32_t *ids, uint32_t capacity,
            uint32_t *needed) {
  if (const int32_t status = check_results(model, xyz == nullptr || (ids == nullptr && capacity > 0)); status != HSP_OK)
    return status;
  hsp::QueryResult result{ids, capacity, 0};
  const hsp::Status status = hsp::find_balls(model->grid, xyz, radius, result);
  if (status != hsp::Status::ok) return hsp::capi::to_c(status);
  return hsp::capi::check_output(ids, capacity, result.hits, needed);
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
  if (status != hsp::Status::ok) return hsp::capi::to_c(status);
  *meets = hsp::any_ball_meets(model->grid, query) ? 1 : 0;
  return HSP_OK;
}

int32_t hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity,
                             uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(model, ids == nullptr && capacity > 0); status != HSP_OK) return status;
  if (ball >= model->balls().n) return HSP_E_ID;
  hsp::QueryResult result{ids, capacity, 0};
  hsp::find_neighbours(model->grid, model->grid.grid_index(ball), result);
  return hsp::capi::check_output(ids, capacity, result.hits, needed);
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
  const int32_t status = hsp::capi::check_output(ids, capacity, begins[n], needed);
  if (status == HSP_OK) hsp::list_neighbours(model->grid, rows, begins, {ids, begins[n]});
  return status;
}

int32_t hsp_query_ray(const hsp_model *model, const double *origin, const double *direction, hsp_ray_hit *hit) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(model, origin == nullptr || direction == nullptr || hit == nullptr);
      status != HSP_OK)
    return status;
  const hsp::BallSet &balls = model->balls();
  hsp::exact::LatticeRay ray;
  if (const hsp::Status status = hsp::round_ray(balls, origin, direction, ray); status != hsp::Status::ok) {
    return hsp::capi::to_c(status);
  }
  const hsp::RayHit found = hsp::first_ball_on_ray(model->grid, ray);
  const hsp::exact::Lattice &lattice = balls.lattice;
  *hit = {{lattice.length(found.point.x), lattice.length(found.point.y), lattice.length(found.point.z)},
          lattice.length(found.distance),
          found.ball == hsp::no_id ? HSP_NONE : balls.caller[found.ball],
          0};
  return HSP_OK;
}
