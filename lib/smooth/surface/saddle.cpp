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

double half_way_between_cusps(const BallSet &balls, uint32_t a, uint32_t b) {
  const exact::LatticeBall own = balls.ball(a);
  const exact::Plane plane = exact::plane_of(own, balls.ball(b));
  const int64_t U = dot(plane.v, plane.v);
  if (plane.h <= 0 || plane.h >= 2 * U) return 0.0;
  const exact::Sphere smaller{4 * (own.radius - balls.probe_steps) * (own.radius + balls.probe_steps), own.index};
  const double Delta = exact::Exact::circle_discriminant(smaller, plane);
  return Delta < 0.0 ? 0.5 * std::sqrt(-Delta / static_cast<double>(U)) : 0.0;
}

SaddlePatches::SaddlePatches(const BallSet &balls, const Boundary &boundary, uint32_t ball)
    : balls_(balls), boundary_(boundary), ball_(ball), rolled_(rolled_ball(balls, boundary, ball)) {}

// Circles for which doubles are not precise enough, small ones and those nearly as large as the probe, come from exact
// integers.
void SaddlePatches::find_circles(const ArcBatch &batch) {
  if (find_saddle_circles(boundary_.target(), batch, rolled_, circles_)) return;
  const exact::LatticeBall own = balls_.ball(ball_);
  for (uint32_t s = 0; s < batch.count + sum_lanes - 1; ++s) {
    if (s < batch.count && circles_.radius[s] == circles_.radius[s]) continue;
    const uint32_t other = batch.other[s];
    circles_.radius[s] = CircleGeometry(exact::sphere_of(own), exact::plane_of(own, balls_.ball(other))).radius;
    circles_.half_way[s] = half_way_between_cusps(balls_, ball_, other);
  }
}

SaddleMeasures SaddlePatches::measure(const ArcBatch &batch) {
  find_circles(batch);
  return measure_saddles(boundary_.target(), batch, circles_, rolled_);
}

SaddleDerivatives SaddlePatches::differentiate(const ArcBatch &batch) {
  find_circles(batch);
  return differentiate_saddles(boundary_.target(), batch, circles_, rolled_);
}

}  // namespace hsp
