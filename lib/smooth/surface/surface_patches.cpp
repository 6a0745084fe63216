#include "surface/surface_patches.hpp"

#include "measure/areas.hpp"
#include "surface/saddle.hpp"
#include "surface/surface_areas.hpp"

namespace hsp {
namespace {

PatchMeasure measure_convex(const BallSet &balls, const Boundary &boundary, uint32_t face) {
  const uint32_t ball = boundary.face(face).ball;
  const BallMeasure whole = measure_face(balls, boundary, face);
  const double shrinkage = shrinkage_of_faces(balls, ball);
  const double p = static_cast<double>(balls.probe_steps);
  return {shrinkage * shrinkage * whole.area, shrinkage * shrinkage * (whole.volume - p * whole.area / 3),
          boundary.component_origin(ball)};
}

// The saddle patch of an arc or a circle: the part at the ball of this element, or the whole.
PatchMeasure measure_saddle(const BallSet &balls, const Boundary &boundary, LoopElement own, LoopElement other,
                            bool both_sides) {
  const uint32_t ball = boundary.face(boundary.face_of(own)).ball;
  const auto part_at = [&](LoopElement element) {
    ArcBatches arc(balls, boundary, element);
    arc.next();
    return SaddlePatches(balls, boundary, boundary.face(boundary.face_of(element)).ball).measure(arc.batch());
  };
  const SaddleMeasures first = part_at(own);
  const SaddleMeasures second = both_sides ? part_at(other) : SaddleMeasures{0.0, 0.0};
  return {first.area + second.area, (first.triple_volume + second.triple_volume) / 3, boundary.component_origin(ball)};
}

}  // namespace

PatchMeasure measure_patch(const SurfaceMap &map, uint32_t patch) {
  const BallSet &balls = map.balls();
  const Boundary &boundary = map.boundary();
  const Surface &surface = map.surface();
  const SurfacePatch record = map.patch(patch);
  if (record.kind == PatchKind::convex) return measure_convex(balls, boundary, record.source);
  if (record.kind == PatchKind::concave) {
    const uint32_t origin = boundary.component_origin(boundary.vertex(record.source).ball[0]);
    if (record.part == no_id) {
      const ConcavePatch whole = surface.patch(record.source);
      return {whole.area, whole.volume, origin};
    }
    const PatchPiece &piece = surface.cut_patches().piece(record.part);
    return {piece.area, piece.volume, origin};
  }
  if (balls.probe_steps == 0) return {};
  if (record.kind == PatchKind::saddle) {
    const uint32_t half_edge = map.half_edge_of(record.source, record.part);
    return measure_saddle(balls, boundary, LoopElement::arc(half_edge), LoopElement::arc(boundary.twin(half_edge)),
                          map.cusped_circle_of(half_edge) == no_id);
  }
  return measure_saddle(balls, boundary, LoopElement::circle(map.circle_on(record.source, record.part)),
                        LoopElement::circle(map.circle_on(record.source, 1 - record.part)),
                        surface.cusped_circles().of_circle(record.source) == no_id);
}

}  // namespace hsp
