#include "mesh/boundary_outline.hpp"

#include "measure/areas.hpp"
#include "mesh/mesh_sizes.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {

Status expected_limits_of_boundary(const BallSet &balls, const Boundary &boundary, double edge, MeshLimits &limits) {
  MeshSizes sizes;
  sizes.add_points(boundary.vertex_count());
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (!boundary.is_exposed(i)) continue;
    const double r = balls.r[i];
    double border = 0.0;
    double own = 0.0;
    const auto add = [&](LoopElement e, bool is_own) {
      const double segments = segments_of_curve(balls, boundary, e, edge);
      border += segments;
      if (is_own) own += segments;
    };
    for (const uint32_t e : boundary.half_edges(i)) {
      const bool lower = balls.ranks_before(i, boundary.half_edge(e).circle);
      add(LoopElement::arc(lower ? e : boundary.twin(e)), lower);
    }
    for (const ClosedHalfEdge e : boundary.circles(i)) add(LoopElement::circle(e), e.side() == 0);
    sizes.add_points(own);
    sizes.add_sphere(border, r > 0.0 ? measure_ball(balls, boundary, i).area / (r * r) : 4 * pi, spacing_on(r, edge));
  }
  return sizes.limits(balls.n, boundary.arc_count() + boundary.circle_count(), limits);
}

double spacing_on(double radius, double edge) {
  return radius > 0.0 ? edge / radius : largest_ring_spacing;
}

MeshVertex mesh_vertex(const BallSet &balls, const Position &position, const Vec3 &normal, uint32_t ball) {
  MeshVertex vertex;
  to_coordinates(balls, position, vertex.position);
  vertex.normal[0] = normal.x;
  vertex.normal[1] = normal.y;
  vertex.normal[2] = normal.z;
  vertex.ball = ball;
  return vertex;
}

MeshVertex vertex_on_ball(const BallSet &balls, uint32_t ball, double radius, const Vec3 &direction) {
  const Vec3 normal = unit(direction, upwards);
  return mesh_vertex(balls, {ball, radius * normal}, normal, ball);
}

void keep_off_neighbours(const BallSet &balls, const Boundary &boundary, uint32_t ball, SphericalPatch &patch) {
  uint32_t latest = no_id;
  const auto keep_off = [&](uint32_t other) {
    if (other == latest) return;
    latest = other;
    const CircleGeometry circle(balls, ball, other);
    patch.keep_off(circle.axis, circle.height / balls.r[ball]);
  };
  // Half-edges of a ball are in the order of their circles, so those of one circle follow each other.
  for (const uint32_t e : boundary.half_edges(ball)) keep_off(boundary.half_edge(e).circle);
  for (const ClosedHalfEdge e : boundary.circles(ball)) keep_off(boundary.neighbour(e));
}

double MeshedFaces::steradians(const BallSet &balls, uint32_t ball) const {
  double area = 0.0;
  visit(ball, [&](uint32_t face, uint32_t) { area += measure_face(balls, boundary_, face).area; });
  const double r = balls.r[ball];
  return r > 0.0 ? area / (r * r) : 0.0;
}

void BoundaryOutline::find_owners(uint32_t c, uint32_t owners[2]) const {
  const LoopElement element = curves_.curve(c).element;
  owners[0] = boundary_.ball_of(element);
  owners[1] = boundary_.neighbour(element);
}

MeshVertex BoundaryOutline::vertex_at(const Position &position, const uint32_t *owners, uint32_t count) const {
  uint32_t ball = owners[0];
  Vec3 sum{0.0, 0.0, 0.0};
  for (uint32_t k = 0; k < count; ++k) {
    const Vec3 arm = direction_from(balls_, owners[k], position);
    const double length = std::sqrt(dot(arm, arm));
    if (length > 0.0) sum = combine(1.0, sum, 1.0 / length, arm);
    if (balls_.given_before(owners[k], ball)) ball = owners[k];
  }
  return mesh_vertex(balls_, position, unit(sum, upwards), ball);
}

MeshVertex BoundaryOutline::corner(uint32_t v) const {
  return vertex_at(position_of_vertex(balls_, boundary_, v), boundary_.vertex(v).ball, 3);
}

void BoundaryOutline::add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const {
  const MeshCurve &curve = curves_.curve(c);
  const CirclePoints points = points_of_curve(balls_, boundary_, curve.element);
  uint32_t owners[2];
  find_owners(c, owners);
  for (uint32_t k = curve.element.is_circle() ? 0 : 1; k < curve.segments; ++k) {
    vertices.push(vertex_at(points.at(k, curve.segments), owners, 2));
  }
}

bool BoundaryOutline::is_too_fine(uint32_t c) const {
  const MeshCurve &curve = curves_.curve(c);
  if (curve.element.is_circle()) return false;
  const double radius = balls_.r[boundary_.ball_of(curve.element.half_edge())];
  return length_of_curve(balls_, boundary_, curve.element) < least_segment * radius * curve.segments;
}

void BoundaryOutline::add_border(uint32_t sphere, SphericalPatch &patch) const {
  keep_off_neighbours(balls_, boundary_, sphere, patch);
  faces_.visit(sphere, [&](uint32_t face, uint32_t number) {
    for (const uint32_t loop : boundary_.loops_of_face(face)) {
      patch.begin_loop(number);
      add_loop(sphere, loop, patch);
    }
  });
}

void BoundaryOutline::add_loop(uint32_t ball, uint32_t loop, SphericalPatch &patch) const {
  const LoopElement start = boundary_.loop_start(loop);
  if (start.is_circle()) return add_points(ball, start, patch);
  uint32_t e = start.half_edge();
  do {
    const HalfEdge &half_edge = boundary_.half_edge(e);
    const Position at_start = position_of_vertex(balls_, boundary_, half_edge.vertex);
    patch.add({direction_from(balls_, ball, at_start),
               half_edge.vertex,
               curves_.of(LoopElement::arc(e)),
               {boundary_.previous_circle(ball, half_edge), half_edge.circle}});
    add_points(ball, LoopElement::arc(e), patch);
    e = half_edge.next;
  } while (e != start.half_edge());
}

void BoundaryOutline::add_points(uint32_t ball, LoopElement e, SphericalPatch &patch) const {
  const uint32_t c = curves_.of(e);
  const MeshCurve &curve = curves_.curve(c);
  if (curve.segments == 1) return;
  const CirclePoints points = points_of_curve(balls_, boundary_, curve.element, least_circle * balls_.r[ball]);
  for_each_point(curve, e.is_circle(), curve.element == e, [&](uint32_t k, uint32_t vertex) {
    const Position point = points.at(k, curve.segments);
    patch.add({direction_from(balls_, ball, point), vertex, c, {boundary_.neighbour(e), no_id}});
  });
}

}  // namespace hsp
