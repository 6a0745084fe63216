#include "mesh/surface_curves.hpp"

namespace hsp {

CreasePoints::CreasePoints(const SurfaceMap &map, uint32_t edge, uint32_t start) : arc_(position_of_edge(map, edge)) {
  x_ = arc_.radius * perpendicular_to(arc_.axis);
  if (start != no_id) {
    const Position from = position_of_corner(map, start);
    x_ = direction_from(map.balls(), arc_.centre.ball, from) - arc_.centre.offset;
  }
}

SaddleBand SurfaceCurves::band_of_arc(uint32_t half_edge) const {
  const uint32_t on_ball_1 = map_.side_of(half_edge) == 1 ? half_edge : boundary().twin(half_edge);
  return {balls(), boundary(), on_ball_1, map_.cusped_circle_of(half_edge) != no_id};
}

SaddleBand SurfaceCurves::band_of_circle(uint32_t circle) const {
  return {balls(), boundary(), map_.circle_on(circle, 1), surface().cusped_circles().of_circle(circle) != no_id};
}

SaddleBand SurfaceCurves::band_of_saddle(uint32_t k) const {
  const uint32_t arcs = boundary().arc_count();
  return k < arcs ? band_of_arc(map_.half_edge_of(k, 1)) : band_of_circle(k - arcs);
}

double SurfaceCurves::segments(uint32_t c, double length) const {
  const SurfaceEdge edge = map_.edge(c);
  if (edge.kind == SurfaceEdgeKind::rim) {
    return segments_of(band_of_arc(edge.source).width(), length,
                       has_ends_of_same_balls(boundary(), edge.source) ? 2.0 : 1.0);
  }
  if (edge.kind == SurfaceEdgeKind::circle_rim) {
    return segments_of(band_of_circle(ClosedHalfEdge::from_id(edge.source).circle()).width(), length, fewest_of_circle);
  }
  if (edge.kind == SurfaceEdgeKind::side) return segments_of(band_of_arc(edge.source).length(edge.part), length, 1.0);
  // Several creases may join the same two corners.
  const ArcPosition arc = position_of_edge(map_, c);
  return segments_of(arc.radius * arc.angle, length, is_closed(c) ? fewest_of_circle : 2.0);
}

bool SurfaceCurves::divide(double length, Patience &patience) {
  double all = 0.0;
  for (uint32_t c = 0; c < curve_count(); ++c) {
    if (!patience.allows(1000)) return false;
    const double wanted = segments(c, length);
    all += wanted;
    if (!(all < max_count)) return false;
    curve_[c] = {c, static_cast<uint32_t>(wanted), 0, false, false};
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
    const SaddleBand band = band_of_arc(edge.source);
    length = edge.kind == SurfaceEdgeKind::rim ? band.way_of_probe() : band.length(edge.part);
  }
  return length < least_segment * probe() * curve_[c].segments;
}

}  // namespace hsp
