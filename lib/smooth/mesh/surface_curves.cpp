#include "mesh/surface_curves.hpp"

namespace hsp {

CirclePoints points_of_crease(const SurfaceMap &map, uint32_t edge, uint32_t start) {
  const ArcPosition arc = position_of_edge(map, edge);
  Vec3 x = arc.radius * perpendicular_to(arc.axis);
  if (start != no_id) {
    x = direction_from(map.balls(), arc.centre.ball, position_of_corner(map, start)) - arc.centre.offset;
  }
  return {arc.centre, arc.angle, x, cross(arc.axis, x)};
}

SaddleBand SurfaceCurves::band_of(LoopElement e) const {
  return {balls(), boundary(), map_.side_of(e) == 1 ? e : map_.across(e), map_.cusped_circle_of(e) != no_id};
}

double SurfaceCurves::segments(uint32_t c, double length) const {
  const SurfaceEdge edge = map_.edge(c);
  if (edge.kind == SurfaceEdgeKind::crease) {
    // Several creases may join the same two corners.
    const ArcPosition arc = position_of_edge(map_, c);
    return segments_of(arc.radius * arc.angle, length, is_closed(c) ? fewest_of_circle : 2.0);
  }
  const SaddleBand band = band_of(edge.element());
  if (edge.kind == SurfaceEdgeKind::side) return segments_of(band.length(edge.part), length, 1.0);
  return segments_of(band.width(), length, fewest_segments(boundary(), edge.element()));
}

bool SurfaceCurves::divide(double length, Patience &patience) {
  double all = 0.0;
  for (uint32_t c = 0; c < curve_count(); ++c) {
    if (!patience.allows(1000)) return false;
    const double wanted = segments(c, length);
    all += wanted;
    if (!(all < max_count)) return false;
    curve_[c] = {{}, static_cast<uint32_t>(wanted), 0, false, false};
  }
  return true;
}

uint32_t SurfaceCurves::partner(uint32_t c) const {
  return map_.edge(c).kind == SurfaceEdgeKind::crease ? c : c ^ 1;
}

bool SurfaceCurves::is_too_fine(uint32_t c) const {
  if (is_closed(c)) return false;
  const SurfaceEdge edge = map_.edge(c);
  double length = 0.0;
  if (edge.kind == SurfaceEdgeKind::crease) {
    const ArcPosition arc = position_of_edge(map_, c);
    length = arc.radius * arc.angle;
  } else {
    const SaddleBand band = band_of(edge.element());
    length = edge.kind == SurfaceEdgeKind::rim ? band.way_of_probe() : band.length(edge.part);
  }
  return length < least_segment * probe() * curve_[c].segments;
}

}  // namespace hsp
