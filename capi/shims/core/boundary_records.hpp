// Records of a boundary, of a union in free space or in a periodic box, each listed once. A class Listing says which
// records are listed, in which order their balls are, and how balls, vertices, circles and faces are written.
#pragma once

#include "conversion.hpp"
#include "measure/boundary_positions.hpp"

namespace hsp::capi {

// Calls put(listing) if exactly listing.*count() records fit.
template <class Listing, class Handle, class Put>
int32_t list_records(const Handle *handle, const void *out, uint32_t capacity, uint32_t *needed,
                     uint32_t (Listing::*count)() const, Put put) {
  const int32_t status =
      check_request(handle, out, capacity, needed, [&](const Handle &h) { return (Listing(h).*count)(); });
  if (status == HSP_OK) put(Listing(*handle));
  return status;
}

// Calls visit(half_edge) for every half-edge of a loop of arcs, in walking order.
template <class Visit>
void for_each_half_edge(const Boundary &boundary, uint32_t loop, Visit visit) {
  const LoopElement start = boundary.loop_start(loop);
  if (start.is_circle()) return;
  uint32_t half_edge = start.half_edge();
  do {
    visit(half_edge);
    half_edge = boundary.half_edge(half_edge).next;
  } while (half_edge != start.half_edge());
}

// The part common to arcs and circles: the circle of balls a and b. ball: the record's field for its balls.
template <class Listing, class Record, class Ball>
void put_circle(const Listing &list, uint32_t a, uint32_t b, Record &record, Ball *ball) {
  const CirclePosition position = position_of_circle(list.balls, a, b);
  list.put_position(position.centre, record.centre);
  list.put_direction(position.axis, record.axis);
  record.radius = list.length(position.radius);
  ball[0] = list.ball(a);
  ball[1] = list.ball(b);
}

template <class Listing, class Record>
void put_vertices(const Listing &list, Record *out) {
  for (uint32_t v = 0; v < list.boundary.vertex_count(); ++v) {
    if (!list.lists_vertex(v)) continue;
    const OrderedVertex vertex = list.in_order(list.boundary.vertex(v));
    Record &record = *out++;
    record = {};
    list.put_position(position_of_vertex(list.balls, list.boundary, v), record.xyz);
    for (int t = 0; t < 3; ++t) Listing::balls_of(record)[t] = list.ball(vertex.ball[t]);
    record.sign = vertex.sign;
    record.flags = list.boundary.vertex(v).tied() ? HSP_VERTEX_TIED : 0;
  }
}

// A half-edge runs clockwise about the axis that leads away from its own ball. An arc runs counter-clockwise about the
// axis that leads away from its first ball: so it starts where the half-edge on that ball ends.
template <class Listing, class Record>
void put_arcs(const Listing &list, Record *out) {
  const Boundary &boundary = list.boundary;
  list.for_each_arc([&](uint32_t ball, uint32_t e) {
    Record &arc = *out++;
    put_circle(list, ball, boundary.half_edge(e).circle, arc, Listing::balls_of(arc));
    arc.vertex[0] = list.vertex(boundary.end_vertex(e));
    arc.vertex[1] = list.vertex(boundary.half_edge(e).vertex);
    arc.face[0] = list.face(boundary.face_of(e));
    arc.face[1] = list.face_across(ball, e);
    arc.angle = list.angle(ball, e);
  });
}

template <class Listing, class Record>
void put_circles(const Listing &list, Record *out) {
  for (uint32_t c = 0; c < list.boundary.circle_count(); ++c) {
    if (!list.lists_circle(c)) continue;
    const CircleRecord &circle = list.boundary.circle(c);
    const uint32_t a = list.side(circle.ball[0], circle.ball[1]);
    put_circle(list, circle.ball[a], circle.ball[1 - a], *out, Listing::balls_of(*out));
    out->face[0] = list.face(list.boundary.face_of_loop(circle.loop[a]));
    out++->face[1] = list.face_across(ClosedHalfEdge(c, a));
  }
}

template <class Listing, class Record>
void put_loops(const Listing &list, Record *out) {
  uint32_t first_arc = 0;
  for (uint32_t loop = 0; loop < list.boundary.loop_count(); ++loop) {
    const LoopElement start = list.boundary.loop_start(loop);
    Record &record = out[loop];
    record = Listing::no_loop;
    record.face = list.boundary.face_of_loop(loop);
    record.first_arc = first_arc;
    if (start.is_circle()) {
      const ClosedHalfEdge circle = start.closed_half_edge();
      record.circle = list.circle(circle);
      record.side = list.side(list.boundary.ball_of(circle), list.boundary.neighbour(circle));
    }
    for_each_half_edge(list.boundary, loop, [&](uint32_t) { ++record.arcs; });
    first_arc += record.arcs;
  }
}

}  // namespace hsp::capi
