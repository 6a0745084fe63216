#include "surface/surface_patches.hpp"

#include "surface/saddle.hpp"
#include "surface/surface_areas.hpp"

namespace hsp {
namespace {

BallMeasure measure_convex(const BallSet &balls, const Boundary &boundary, uint32_t face) {
  const BallMeasure whole = measure_face(balls, boundary, face);
  const double shrinkage = shrinkage_of_faces(balls, boundary.face(face).ball);
  const double p = static_cast<double>(balls.probe_steps);
  return {shrinkage * shrinkage * whole.area, shrinkage * shrinkage * (whole.volume - p * whole.area / 3)};
}

// The saddle patch of an arc or a circle: the part at the ball of this element if there are cusps, else the whole.
BallMeasure measure_saddle(const SurfaceMap &map, LoopElement own) {
  const auto part_at = [&](LoopElement element) {
    ArcBatches arc(map.balls(), map.boundary(), element);
    arc.next();
    return SaddlePatches(map.balls(), map.boundary(), map.boundary().ball_of(element)).measure(arc.batch());
  };
  const SaddleMeasures first = part_at(own);
  const SaddleMeasures second =
      map.cusped_circle_of(own) == no_id ? part_at(map.across(own)) : SaddleMeasures{0.0, 0.0};
  return {first.area + second.area, (first.triple_volume + second.triple_volume) / 3};
}

}  // namespace

BallMeasure measure_patch(const SurfaceMap &map, uint32_t patch) {
  const SurfacePatch record = map.patch(patch);
  if (record.kind == PatchKind::convex) return measure_convex(map.balls(), map.boundary(), record.source);
  if (record.kind == PatchKind::concave && record.part == no_id) {
    const ConcavePatch whole = map.surface().patch(record.source);
    return {whole.area, whole.volume};
  }
  if (record.kind == PatchKind::concave) {
    const PatchPiece &piece = map.surface().cut_patches().piece(record.part);
    return {piece.area, piece.volume};
  }
  if (map.balls().probe_steps == 0) return {};
  return measure_saddle(map, map.element_of(record.source, record.part));
}

}  // namespace hsp
