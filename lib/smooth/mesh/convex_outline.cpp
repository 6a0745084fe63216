// The borders of the convex patches of one ball. Points are given to SphericalPatch as the directions from the ball's
// centre to the probe's centre: so even a ball of radius 0 has its patches.
#include "mesh/surface_outline.hpp"

namespace hsp {
namespace {

// The points of a rim from this corner on, or of a whole circle.
void add_rim(const SurfaceCurves &curves, uint32_t ball, uint32_t h, uint32_t corner, SphericalPatch &patch) {
  const BallSet &balls = curves.balls();
  const uint32_t c = h / 2;
  const MeshCurve &curve = curves.curve(c);
  const bool is_circle = corner == no_id;
  if (!is_circle) {
    const Position start = position_of_vertex(balls, curves.boundary(), corner / 3);
    patch.add({direction_from(balls, ball, start), corner, c, {no_id, no_id}});
  }
  if (curve.segments == 1) return;
  const SaddleBand band = curves.band_of(curves.map().edge(c).element());
  for_each_point(curve, is_circle, h % 2 == 0, [&](uint32_t k, uint32_t vertex) {
    const double least_radius = is_circle ? least_circle * balls.r[ball] : 0.0;
    const Position probe = band.probe(band.outward(k, curve.segments), least_radius);
    patch.add({direction_from(balls, ball, probe), vertex, c, {no_id, no_id}});
  });
}

}  // namespace

void SurfaceOutline::add_convex_border(uint32_t ball, SphericalPatch &patch) const {
  keep_off_neighbours(balls(), boundary(), ball, patch);
  faces().visit(ball, [&](uint32_t face, uint32_t number) {
    map().for_each_loop(face, [&](uint32_t loop) {
      patch.begin_loop(number);
      map().for_each_edge(loop, [&](uint32_t h) { add_rim(*this, ball, h, map().origin(h), patch); });
    });
  });
}

}  // namespace hsp
