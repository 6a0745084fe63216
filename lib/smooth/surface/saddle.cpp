#include "surface/saddle.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

RolledBall rolled_ball(const BallSet &balls, const Boundary &boundary, uint32_t ball) {
  const Vec3 arm = offset_from_origin(balls, boundary, ball);
  return {balls.r.data(), balls.r[ball], static_cast<double>(balls.probe_steps), {arm.x, arm.y, arm.z}};
}

}  // namespace

SaddlePatches::SaddlePatches(const BallSet &balls, const Boundary &boundary, uint32_t ball)
    : balls_(balls), boundary_(boundary), ball_(ball), rolled_(rolled_ball(balls, boundary, ball)) {}

// Small circles from exact integers.
void SaddlePatches::find_circle_radii(const ArcBatch &batch) {
#if HSP_AVX2
  const bool served = boundary_.has_wide_code() ? find_circle_radii_avx2(batch, rolled_.radius, circle_radius_)
                                                : hsp::find_circle_radii(batch, rolled_.radius, circle_radius_);
#else
  const bool served = hsp::find_circle_radii(batch, rolled_.radius, circle_radius_);
#endif
  if (served) return;
  const exact::LatticeBall own = balls_.ball(ball_);
  for (uint32_t s = 0; s < batch.count + sum_lanes - 1; ++s) {
    if (s < batch.count && circle_radius_[s] == circle_radius_[s]) continue;
    const uint32_t other = batch.other[s];
    circle_radius_[s] = CircleGeometry(exact::sphere_of(own), exact::plane_of(own, balls_.ball(other))).radius;
  }
}

SaddleMeasures SaddlePatches::measure(const ArcBatch &batch) {
  find_circle_radii(batch);
#if HSP_AVX2
  if (boundary_.has_wide_code()) return measure_saddles_avx2(batch, circle_radius_, rolled_);
#endif
  return measure_saddles(batch, circle_radius_, rolled_);
}

SaddleDerivatives SaddlePatches::differentiate(const ArcBatch &batch) {
  find_circle_radii(batch);
#if HSP_AVX2
  if (boundary_.has_wide_code()) return differentiate_saddles_avx2(batch, circle_radius_, rolled_);
#endif
  return differentiate_saddles(batch, circle_radius_, rolled_);
}

}  // namespace hsp
