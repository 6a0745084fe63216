#include "surface/surface_areas.hpp"

#include "surface/saddle.hpp"

namespace hsp {

namespace {

// The measure of one of a ball's faces, or of all if `one` is no_id.
SurfaceMeasure measure_faces_of_ball(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t i,
                                     uint32_t one) {
  SurfaceMeasure result;
  double triple_volume = 0.0;
  FreeSurface face(boundary, balls.r[i]);
  ArcBatches arcs(balls, boundary, i, one);
  SaddlePatches saddles(balls, boundary, i);
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    face.add(batch);
    if (balls.probe_steps == 0) continue;
    const SaddleMeasures measures = saddles.measure(batch);
    result.saddle += measures.area;
    triple_volume += measures.triple_volume;
  }
  const ConvexPatches convex(balls, boundary, i, one, face);
  result.convex = convex.area;
  triple_volume += convex.triple_volume;

  double concave = 0.0;
  double concave_volume = 0.0;
  for (const uint32_t e : boundary.half_edges(i)) {
    if (one != no_id && boundary.face_of(e) != one) continue;
    const ConcavePatch patch = surface.patch(boundary.half_edge(e).vertex);
    concave += patch.area;
    concave_volume += patch.volume;
  }
  result.concave = concave / 3;
  result.volume = (triple_volume + concave_volume) / 3;
  return result;
}

}  // namespace

SurfaceMeasure measure_surface_of_ball(const BallSet &balls, const Boundary &boundary, const Surface &surface,
                                       uint32_t i) {
  SurfaceMeasure sum;
  for_each_chosen_part(boundary, surface.chosen(), i,
                       [&](uint32_t one) { sum += measure_faces_of_ball(balls, boundary, surface, i, one); });
  return sum;
}

}  // namespace hsp
