#include "hsp_periodic.hpp"
#include "loop_walk.hpp"
#include "measure/boundary_positions.hpp"
#include "periodic/periodic_records.hpp"
#include "periodic_shifts.hpp"

using hsp::capi::check_request;
using hsp::capi::for_each_half_edge;
using hsp::capi::LibraryArithmetic;

namespace {

// The ball of the grid, or an image, from where the caller has put it.
hsp_image image_of(const hsp::PeriodicUnion &periodic, uint32_t grid_ball) {
  const hsp::PeriodicImages &images = periodic.images();
  const uint32_t k = periodic.balls().caller[grid_ball];
  hsp_image result{};
  result.ball = images.ball_of(k);
  hsp::capi::put_shift(images.box().in_given_vectors(images.shift_from_caller(k)), result.shift);
  return result;
}

hsp_periodic_id record_to_c(const hsp::PeriodicUnion &periodic, const hsp::MovedRecord &record) {
  hsp_periodic_id result{};
  result.id = record.id;
  hsp::capi::put_shift(periodic.images().box().in_given_vectors(record.shift), result.shift);
  return result;
}

// The set has its lengths in steps.
void put_position(const hsp::PeriodicUnion &periodic, const hsp::Position &position, double (&xyz)[3]) {
  hsp::to_coordinates(periodic.balls(), position, xyz);
  for (double &x : xyz) x = periodic.images().lattice().length(x);
}

// Common to arcs and circles: the circle of balls a and b of the grid.
template <class Record>
void put_circle(const hsp::PeriodicUnion &periodic, uint32_t a, uint32_t b, Record &record) {
  const hsp::CirclePosition position = hsp::position_of_circle(periodic.balls(), a, b);
  put_position(periodic, position.centre, record.centre);
  hsp::capi::to_array(position.axis, record.axis);
  record.radius = periodic.images().lattice().length(position.radius);
  record.image[0] = image_of(periodic, a);
  record.image[1] = image_of(periodic, b);
}

// 0 on the ball that a record has first, 1 on the other one.
uint32_t side_in_box(const hsp::PeriodicUnion &periodic, uint32_t own, uint32_t other) {
  return periodic.is_listed(periodic.balls().caller[own], periodic.balls().caller[other]) ? 0 : 1;
}

}  // namespace

int32_t hsp_periodic_get_vertices(const hsp_periodic *periodic, hsp_periodic_vertex *out, uint32_t capacity,
                                  uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.builder.counts().vertices; });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::Boundary &boundary = structure.boundary();
  uint32_t written = 0;
  for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
    if (!structure.listed_vertices().has(v)) continue;
    const hsp::OrderedVertex vertex = structure.in_listed_order(boundary.vertex(v));
    hsp_periodic_vertex &record = out[written++];
    put_position(structure, hsp::position_of_vertex(structure.balls(), boundary, v), record.xyz);
    for (int t = 0; t < 3; ++t) record.image[t] = image_of(structure, vertex.ball[t]);
    record.sign = vertex.sign;
    record.flags = boundary.vertex(v).tied() ? HSP_VERTEX_TIED : 0;
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_arcs(const hsp_periodic *periodic, hsp_periodic_arc *out, uint32_t capacity,
                              uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.builder.counts().arcs; });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::Boundary &boundary = structure.boundary();
  uint32_t written = 0;
  for (uint32_t own = 0; own < periodic->balls(); ++own) {
    for (const uint32_t e : boundary.half_edges(own)) {
      if (!structure.listed_half_edges().has(e)) continue;
      hsp_periodic_arc &arc = out[written++];
      put_circle(structure, own, boundary.half_edge(e).circle, arc);
      arc.angle = hsp::angle_of_listed_arc(structure, own, e);
      // A half-edge runs clockwise about the axis away from its own ball, the arc counter-clockwise.
      arc.vertex[0] = record_to_c(structure, hsp::listed_vertex(structure, boundary.end_vertex(e)));
      arc.vertex[1] = record_to_c(structure, hsp::listed_vertex(structure, boundary.half_edge(e).vertex));
      arc.face[0] = record_to_c(structure, {boundary.face_of(e), {}});
      arc.face[1] = record_to_c(structure, hsp::face_across(structure, own, e));
    }
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_circles(const hsp_periodic *periodic, hsp_periodic_circle *out, uint32_t capacity,
                                 uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.builder.counts().circles; });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::Boundary &boundary = structure.boundary();
  uint32_t written = 0;
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    if (!structure.listed_circles().has(c)) continue;
    const hsp::CircleRecord &circle = boundary.circle(c);
    const uint32_t a = side_in_box(structure, circle.ball[0], circle.ball[1]);
    const hsp::ClosedHalfEdge own(c, a);
    hsp_periodic_circle &record = out[written++];
    put_circle(structure, circle.ball[a], circle.ball[1 - a], record);
    record.face[0] = record_to_c(structure, {boundary.face_of_loop(circle.loop[a]), {}});
    record.face[1] = record_to_c(structure, hsp::face_across(structure, own));
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_faces(const hsp_periodic *periodic, hsp_periodic_face *out, uint32_t capacity,
                               uint32_t *needed) {
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.builder.counts().faces; });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::Boundary &boundary = structure.boundary();
  for (uint32_t f = 0; f < boundary.face_count(); ++f) {
    const hsp::IdRange loops = boundary.loops_of_face(f);
    out[f] = {image_of(structure, boundary.face(f).ball), loops.size(), boundary.face(f).shell, loops.first, 0};
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_loops(const hsp_periodic *periodic, hsp_periodic_loop *out, uint32_t capacity,
                               uint32_t *needed) {
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.builder.counts().loops; });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::Boundary &boundary = structure.boundary();
  uint32_t first_arc = 0;
  for (uint32_t loop = 0; loop < boundary.loop_count(); ++loop) {
    const hsp::LoopElement start = boundary.loop_start(loop);
    hsp_periodic_loop &record = out[loop];
    record = {{HSP_NONE, {0, 0, 0}}, boundary.face_of_loop(loop), 0, first_arc, 0};
    if (start.is_circle()) {
      const hsp::ClosedHalfEdge circle = start.closed_half_edge();
      record.circle = record_to_c(structure, hsp::listed_circle(structure, circle));
      record.side = side_in_box(structure, boundary.ball_of(circle), boundary.neighbour(circle));
    }
    for_each_half_edge(boundary, loop, [&](uint32_t) { ++record.arcs; });
    first_arc += record.arcs;
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_loop_arcs(const hsp_periodic *periodic, hsp_periodic_loop_arc *out, uint32_t capacity,
                                   uint32_t *needed) {
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return 2 * p.builder.counts().arcs; });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::Boundary &boundary = structure.boundary();
  uint32_t written = 0;
  for (uint32_t loop = 0; loop < boundary.loop_count(); ++loop) {
    const uint32_t ball = boundary.face(boundary.face_of_loop(loop)).ball;
    for_each_half_edge(boundary, loop, [&](uint32_t e) {
      hsp_periodic_loop_arc &record = out[written++];
      record.arc = record_to_c(structure, hsp::listed_arc(structure, ball, e));
      record.vertex = record_to_c(structure, hsp::listed_vertex(structure, boundary.half_edge(e).vertex));
      record.side = side_in_box(structure, ball, boundary.half_edge(e).circle);
      record.reserved = 0;
    });
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_balls(const hsp_periodic *periodic, hsp_ball *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.balls(); });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  for (uint32_t i = 0; i < periodic->balls(); ++i) {
    const uint32_t ball = structure.grid().grid_index(i);
    const hsp::IdRange faces = structure.boundary().faces(ball);
    out[i] = {faces.size(), faces.empty() ? HSP_NONE : faces.first, structure.windings().component(i),
              structure.boundary().is_contained(ball) ? HSP_BALL_CONTAINED : 0};
  }
  return HSP_OK;
}
