// The query for the first ball on a ray.
#include "hsp_model.hpp"
#include "model/ray_query.hpp"

using namespace hsp::capi;

int32_t hsp_query_ray(const hsp_model *model, const double *origin, const double *direction, hsp_ray_hit *hit) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(model, origin == nullptr || direction == nullptr || hit == nullptr);
      status != HSP_OK)
    return status;
  const hsp::BallSet &balls = model->balls();
  hsp::exact::LatticeRay ray;
  if (const hsp::Status status = hsp::round_ray(balls, origin, direction, ray); status != hsp::Status::ok) {
    return to_c(status);
  }
  const hsp::RayHit found = hsp::first_ball_on_ray(model->grid, ray);
  const hsp::exact::Lattice &lattice = balls.lattice;
  *hit = {{lattice.length(found.point.x), lattice.length(found.point.y), lattice.length(found.point.z)},
          lattice.length(found.distance),
          found.ball == hsp::no_id ? HSP_NONE : balls.caller[found.ball],
          0};
  return HSP_OK;
}
