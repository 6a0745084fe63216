#include "mesh/convex_outline.hpp"

namespace hsp {

void ConvexOutline::add_border(SphericalPatch &patch) const {
  keep_off_neighbours(curves_.balls(), curves_.boundary(), ball_, patch);
  curves_.faces().visit(ball_, [&](uint32_t face, uint32_t number) {
    curves_.map().for_each_loop(face, [&](uint32_t loop) {
      patch.begin_loop(number);
      add_loop(loop, patch);
    });
  });
}

void ConvexOutline::add_loop(uint32_t loop, SphericalPatch &patch) const {
  const SurfaceMap &map = curves_.map();
  map.for_each_edge(loop, [&](uint32_t h) {
    const uint32_t corner = map.origin(h);
    if (corner == no_id) {
      add_circle(h, patch);
    } else {
      add_arc(h, corner, patch);
    }
  });
}

void ConvexOutline::add_circle(uint32_t h, SphericalPatch &patch) const {
  const BallSet &balls = curves_.balls();
  const uint32_t c = h / 2;
  const MeshCurve &curve = curves_.curve(c);
  const SaddleBand band = curves_.band_of_circle(ClosedHalfEdge::from_id(curves_.map().edge(c).source).circle());
  for (uint32_t k = 0; k < curve.segments; ++k) {
    const uint32_t at = h % 2 == 0 ? k : curve.segments - 1 - k;
    const Position probe = band.probe(band.outward(at, curve.segments), least_circle * balls.r[ball_]);
    patch.add({direction_from(balls, ball_, probe), curve.first_sample + at, c, {no_id, no_id}});
  }
}

void ConvexOutline::add_arc(uint32_t h, uint32_t corner, SphericalPatch &patch) const {
  const BallSet &balls = curves_.balls();
  const uint32_t c = h / 2;
  const MeshCurve &curve = curves_.curve(c);
  const Position start = position_of_vertex(balls, curves_.boundary(), corner / 3);
  patch.add({direction_from(balls, ball_, start), corner, c, {no_id, no_id}});
  if (curve.segments == 1) return;
  const SaddleBand band = curves_.band_of_arc(curves_.map().edge(c).source);
  for (uint32_t k = 1; k < curve.segments; ++k) {
    const uint32_t at = h % 2 == 0 ? k : curve.segments - k;
    const Position probe = band.probe(band.outward(at, curve.segments));
    patch.add({direction_from(balls, ball_, probe), curve.first_sample + at - 1, c, {no_id, no_id}});
  }
}

}  // namespace hsp
