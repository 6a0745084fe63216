// What is seen of balls and sticks as a subdivision of the view plane: a visibility map of them. Records are those of a
// VisibilityMap, with bodies in place of balls and the curves of stick_scene.hpp. For each body that is seen there is
// also the first of its loops, in an order for painting.
#pragma once

#include "maps/edge_geometry.hpp"
#include "maps/stick_scene.hpp"

namespace hsp {

struct StickRegions {
  bool exist = false;
  double perturbation = 0.0;  // no centre was moved farther, in lattice steps
  ViewFrame frame;
  StickScene scene;
  uint32_t components = 0;
  uint32_t paths = 0;               // bodies that are seen
  FixedVector<MapVertex> vertices;  // [edges]
  FixedVector<MapEdge> edges;
  FixedVector<MapHalfEdge> half_edges;  // [2 edges]
  FixedVector<MapLoop> loops;           // [2 edges] those of a body follow each other; background last
  FixedVector<MapFace> faces;           // [2 edges + 1] the unbounded one, background, then in the order of loops
  Span<uint32_t> first_loop;            // [paths] of each body that is seen, farthest first
  Span<uint32_t> first_face;            // [bodies] no_id of those without faces

  // The body that a path is of.
  uint32_t owner_of(uint32_t path) const { return loops[first_loop[path]].owner; }
  uint32_t origin(uint32_t half_edge) const { return edges[half_edge / 2].vertex[half_edge % 2]; }
  uint32_t face_of(uint32_t half_edge) const { return loops[half_edges[half_edge].loop].face; }
  // The first face that shows a body or, for no_id, the background; no_id if there is none.
  uint32_t first_face_of(uint32_t owner) const { return owner == no_id ? 0 : first_face[owner]; }
  // The face after another one of the same owner; no_id after the last.
  uint32_t next_face_of(uint32_t face) const {
    return face + 1 < faces.size() && faces[face + 1].owner == faces[face].owner ? face + 1 : no_id;
  }
  // The body on the left, no_id where that is known from other edges only.
  uint32_t left_of(uint32_t half_edge) const {
    const MapEdge &edge = edges[half_edge / 2];
    if (edge.is_silhouette()) return half_edge % 2 == 0 ? edge.ball : no_id;
    return half_edge % 2 == 0 ? edge.nearer : edge.ball;
  }
  void carve(Workspace &workspace, const StickLimits &limits) {
    const uint64_t most = limits.edges;
    const uint64_t bodies = limits.balls + 2 * static_cast<uint64_t>(limits.sticks);
    vertices = FixedVector<MapVertex>(workspace.take<MapVertex>(most));
    edges = FixedVector<MapEdge>(workspace.take<MapEdge>(most));
    half_edges = FixedVector<MapHalfEdge>(workspace.take<MapHalfEdge>(2 * most));
    loops = FixedVector<MapLoop>(workspace.take<MapLoop>(2 * most));
    faces = FixedVector<MapFace>(workspace.take<MapFace>(2 * most + 1));
    first_loop = workspace.take<uint32_t>(bodies);
    first_face = workspace.take<uint32_t>(bodies);
  }
  void clear() {
    exist = false;
    perturbation = 0.0;
    components = 0;
    paths = 0;
    vertices.clear();
    edges.clear();
    half_edges.clear();
    loops.clear();
    faces.clear();
  }
};

// For what holds for maps of whatever bodies; lines as ellipses without a minor axis, from one end of the major one to
// the other.
inline EdgeCurve curve_of(const StickRegions &regions, uint32_t e) {
  const MapEdge &edge = regions.edges[e];
  if (!regions.scene.is_straight(edge.ball, edge.nearer)) {
    const RoundCurve curve = regions.scene.round_curve(edge.ball, edge.nearer);
    return {EdgeEllipse(curve.middle, curve.first, curve.second), edge.from, edge.to};
  }
  const MapVertex &v = regions.vertices[edge.vertex[0]];
  const MapVertex &w = regions.vertices[edge.vertex[1]];
  const Vec3 from{v.x, v.y, 0.0};
  const Vec3 to{w.x, w.y, 0.0};
  return {EdgeEllipse(combine(0.5, from, 0.5, to), 0.5 * (to - from), Vec3{}), -pi, 0.0};
}

inline MapBodies bodies_of(const StickRegions &regions) {
  const StickScene &scene = regions.scene;
  MapBodies bodies{scene.balls.size() + 2 * scene.sticks.size(), 0.0};
  for (const SeenBall &ball : scene.balls) bodies.cover(ball.r);
  for (const Stick &stick : scene.sticks) bodies.cover(stick.length);
  return bodies;
}

inline Vec3 point_of(const StickRegions &regions, const MapEdge &edge, double t) {
  return regions.scene.at(edge.ball, edge.nearer, t);
}

inline Vec3 middle_of(const StickRegions &regions, const MapEdge &edge) {
  return point_of(regions, edge, 0.5 * (edge.from + edge.to));
}

// Of a half of a stick the rectangle around the whole stick.
inline double silhouette_area(const StickRegions &regions, uint32_t body, double margin) {
  if (regions.scene.is_ball(body)) return silhouette_area(regions.scene.balls[body], margin);
  const Stick &stick = regions.scene.stick_at(body);
  const double half = stick.radius + margin;
  return 2 * half * (stick.length * stick.seen + 2 * half);
}
inline bool may_be_seen(const StickRegions &regions, uint32_t body, const Vec3 &p, double margin) {
  const StickScene &scene = regions.scene;
  if (scene.is_ball(body)) return may_be_seen(scene.balls[body], p, margin);
  const Stick &stick = scene.stick_at(body);
  const double half = stick.radius + margin;
  const double dx = p.x - stick.foot.x;
  const double dy = p.y - stick.foot.y;
  const double along = dx * stick.e[0] + dy * stick.e[1];
  const StickFront front = front_of(stick, p.x, p.y);
  const double above = front.z - p.z;
  return front.beside >= -margin && along >= -half && along <= stick.length * stick.seen + half &&
         !(front.exists && (above < front.beside ? above : front.beside) > margin);
}

}  // namespace hsp
