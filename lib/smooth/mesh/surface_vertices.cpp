// The vertices of a mesh that patches of the smooth surface share: its corners, and the points of its curves.
#include "mesh/surface_curves.hpp"

namespace hsp {

// The vertex at a point of creases, where patches of the probes at several vertices meet.
MeshVertex SurfaceCurves::at_creases(const Position &position, const uint32_t *vertices, uint32_t count) const {
  Vec3 sum{0.0, 0.0, 0.0};
  for (uint32_t k = 0; k < count; ++k) sum = sum + probe_at(vertices[k]).way_from(position);
  const ProbeSphere first = probe_at(vertices[0]);
  return mesh_vertex(balls(), position, unit(sum, upwards), first.nearest_ball(-first.way_from(position)));
}

// The patches at a cusp are those of the probes at the ends of the circle's arcs. A whole circle has a single patch
// around the axis: there the normal is along the axis.
Vec3 SurfaceCurves::normal_at_cusp(uint32_t k, uint32_t side, const Position &position) const {
  const CuspedCircles &cusped = surface().cusped_circles();
  const CirclePosition circle = position_of_circle(balls(), cusped.ball(k, side), cusped.ball(k, 1 - side));
  Vec3 sum{0.0, 0.0, 0.0};
  for (const uint32_t e : cusped.half_edges(k)) {
    if (!surface().chosen().has(boundary().face_of(e))) continue;
    const uint32_t ends[2] = {boundary().half_edge(e).vertex, boundary().end_vertex(e)};
    for (const uint32_t v : ends) sum = sum + probe_at(v).way_from(position);
  }
  return unit(sum, circle.axis);
}

MeshVertex SurfaceCurves::corner(uint32_t id) const {
  if (id < map().first_cusp()) {
    const uint32_t ball = boundary().vertex(id / 3).ball[id % 3];
    const Vec3 arm = direction_from(balls(), ball, probe_at(id / 3).centre());
    const double R = balls().r[ball];
    return mesh_vertex(balls(), {ball, (R - probe()) / R * arm}, unit(arm, upwards), ball);
  }
  const Position position = position_of_corner(map(), id);
  if (id < map().first_crease_corner()) {
    const uint32_t k = (id - map().first_cusp()) / 2;
    const uint32_t side = (id - map().first_cusp()) % 2;
    return mesh_vertex(balls(), position, normal_at_cusp(k, side, position), surface().cusped_circles().ball(k, side));
  }
  const CutPatches &cut = surface().cut_patches();
  const uint32_t arc = cut.crease_corners().member(id - map().first_crease_corner());
  const uint32_t vertices[3] = {cut.vertex_of_arc(arc), cut.arc(arc).across, cut.arc(cut.previous(arc)).across};
  return at_creases(position, vertices, 3);
}

void SurfaceCurves::add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const {
  const SurfaceEdge edge = map().edge(c);
  const uint32_t segments = curve(c).segments;
  if (edge.kind == SurfaceEdgeKind::crease) {
    const CutPatches &cut = surface().cut_patches();
    const uint32_t start = map().origin(2 * c);
    const CirclePoints points = points_of_crease(map(), c, start);
    const uint32_t both[2] = {cut.vertex_of_arc(edge.source), cut.arc(edge.source).across};
    for (uint32_t k = start == no_id ? 0 : 1; k < segments; ++k) {
      vertices.push(at_creases(points.at(k, segments), both, 2));
    }
    return;
  }
  const SaddleBand band = band_of(edge.element());
  const uint32_t side = map().side_of(edge.element());
  for (uint32_t k = edge.kind == SurfaceEdgeKind::circle_rim ? 0 : 1; k < segments; ++k) {
    const SaddleBand::Point point = edge.kind == SurfaceEdgeKind::side
                                        ? band.at(band.outward_at_end(1 - side), edge.part, k, segments)
                                        : band.on_ball(side, band.outward(k, segments));
    vertices.push(vertex_of_band(balls(), point));
  }
}

}  // namespace hsp
