#include "boundary_records.hpp"
#include "hsp_periodic.hpp"
#include "periodic/periodic_records.hpp"
#include "periodic_shifts.hpp"

using namespace hsp::capi;

namespace {

// Each record is listed once, with its first ball at its place in the box. Lengths of the set are in steps.
struct Listing {
  explicit Listing(const hsp_periodic &handle)
      : periodic(handle.builder), boundary(periodic.boundary()), balls(periodic.balls()) {}

  uint32_t vertices() const { return periodic.counts().vertices; }
  uint32_t arcs() const { return periodic.counts().arcs; }
  uint32_t circles() const { return periodic.counts().circles; }
  uint32_t loops() const { return periodic.counts().loops; }
  bool lists_vertex(uint32_t vertex) const { return periodic.listed_vertices().has(vertex); }
  bool lists_circle(uint32_t circle) const { return periodic.listed_circles().has(circle); }
  hsp::OrderedVertex in_order(const hsp::VertexRecord &vertex) const { return periodic.in_listed_order(vertex); }
  template <class Visit>
  void for_each_arc(Visit visit) const {
    for (uint32_t own = 0; own < periodic.images().balls(); ++own) {
      for (const uint32_t e : boundary.half_edges(own)) {
        if (periodic.listed_half_edges().has(e)) visit(own, e);
      }
    }
  }
  // 0 if ball `own` is the first ball of a record, 1 if it is the other one.
  uint32_t side(uint32_t own, uint32_t other) const {
    return periodic.is_listed(balls.caller[own], balls.caller[other]) ? 0 : 1;
  }
  // A ball or image of the grid, with its shift from where the caller has put the ball.
  hsp_image ball(uint32_t grid_ball) const {
    const hsp::PeriodicImages &images = periodic.images();
    const uint32_t k = balls.caller[grid_ball];
    hsp_image result{};
    result.ball = images.ball_of(k);
    put_shift(images.box().in_given_vectors(images.shift_from_caller(k)), result.shift);
    return result;
  }
  template <class Record>
  static hsp_image *balls_of(Record &record) {
    return record.image;
  }
  hsp_periodic_id moved(const hsp::MovedRecord &record) const {
    hsp_periodic_id result{};
    result.id = record.id;
    put_shift(periodic.images().box().in_given_vectors(record.shift), result.shift);
    return result;
  }
  hsp_periodic_id vertex(uint32_t id) const { return moved(hsp::listed_vertex(periodic, id)); }
  hsp_periodic_id face(uint32_t id) const { return moved({id, {}}); }
  hsp_periodic_id face_across(uint32_t own, uint32_t e) const { return moved(hsp::face_across(periodic, own, e)); }
  hsp_periodic_id face_across(hsp::ClosedHalfEdge own) const { return moved(hsp::face_across(periodic, own)); }
  hsp_periodic_id circle(hsp::ClosedHalfEdge own) const { return moved(hsp::listed_circle(periodic, own)); }
  static constexpr hsp_periodic_loop no_loop{{HSP_NONE, {0, 0, 0}}, 0, 0, 0, 0};
  double angle(uint32_t own, uint32_t e) const { return hsp::angle_of_listed_arc(periodic, own, e); }
  void put_position(const hsp::Position &position, double (&xyz)[3]) const {
    hsp::to_coordinates(balls, position, xyz);
    for (double &x : xyz) x = length(x);
    periodic.images().box().frame().turn_back(xyz);
  }
  void put_direction(const hsp::Vec3 &direction, double (&xyz)[3]) const {
    to_array(periodic.images().box().frame().turned_back(direction), xyz);
  }
  double length(double steps) const { return periodic.images().lattice().length(steps); }

  const hsp::PeriodicUnion &periodic;
  const hsp::Boundary &boundary;
  const hsp::BallSet &balls;
};

}  // namespace

int32_t hsp_periodic_get_vertices(const hsp_periodic *periodic, hsp_periodic_vertex *out, uint32_t capacity,
                                  uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_records(periodic, out, capacity, needed, &Listing::vertices,
                      [out](const Listing &l) { put_vertices(l, out); });
}

int32_t hsp_periodic_get_arcs(const hsp_periodic *periodic, hsp_periodic_arc *out, uint32_t capacity,
                              uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_records(periodic, out, capacity, needed, &Listing::arcs, [out](const Listing &l) { put_arcs(l, out); });
}

int32_t hsp_periodic_get_circles(const hsp_periodic *periodic, hsp_periodic_circle *out, uint32_t capacity,
                                 uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_records(periodic, out, capacity, needed, &Listing::circles,
                      [out](const Listing &l) { put_circles(l, out); });
}

int32_t hsp_periodic_get_faces(const hsp_periodic *periodic, hsp_periodic_face *out, uint32_t capacity,
                               uint32_t *needed) {
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.builder.counts().faces; });
  if (status != HSP_OK) return status;
  const Listing list(*periodic);
  for (uint32_t f = 0; f < list.boundary.face_count(); ++f) {
    const hsp::IdRange loops = list.boundary.loops_of_face(f);
    out[f] = {list.ball(list.boundary.face(f).ball), loops.size(), list.boundary.face(f).shell, loops.first, 0};
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_loops(const hsp_periodic *periodic, hsp_periodic_loop *out, uint32_t capacity,
                               uint32_t *needed) {
  return list_records(periodic, out, capacity, needed, &Listing::loops, [out](const Listing &l) { put_loops(l, out); });
}

int32_t hsp_periodic_get_loop_arcs(const hsp_periodic *periodic, hsp_periodic_loop_arc *out, uint32_t capacity,
                                   uint32_t *needed) {
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return 2 * p.builder.counts().arcs; });
  if (status != HSP_OK) return status;
  const Listing list(*periodic);
  uint32_t written = 0;
  for (uint32_t loop = 0; loop < list.boundary.loop_count(); ++loop) {
    const uint32_t ball = list.boundary.face(list.boundary.face_of_loop(loop)).ball;
    for_each_half_edge(list.boundary, loop, [&](uint32_t e) {
      hsp_periodic_loop_arc &record = out[written++];
      record.arc = list.moved(hsp::listed_arc(list.periodic, ball, e));
      record.vertex = list.vertex(list.boundary.half_edge(e).vertex);
      record.side = list.side(ball, list.boundary.half_edge(e).circle);
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
