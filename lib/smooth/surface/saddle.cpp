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
  if (hsp::find_circle_radii(boundary_.target(), batch, rolled_.radius, circle_radius_)) return;
  const exact::LatticeBall own = balls_.ball(ball_);
  for (uint32_t s = 0; s < batch.count + sum_lanes - 1; ++s) {
    if (s < batch.count && circle_radius_[s] == circle_radius_[s]) continue;
    const uint32_t other = batch.other[s];
    circle_radius_[s] = CircleGeometry(exact::sphere_of(own), exact::plane_of(own, balls_.ball(other))).radius;
  }
}

SaddleMeasures SaddlePatches::measure(const ArcBatch &batch) {
  find_circle_radii(batch);
  return measure_saddles(boundary_.target(), batch, circle_radius_, rolled_);
}

SaddleDerivatives SaddlePatches::differentiate(const ArcBatch &batch) {
  find_circle_radii(batch);
  return differentiate_saddles(boundary_.target(), batch, circle_radius_, rolled_);
}

}  // namespace hsp
