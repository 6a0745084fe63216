// hsp_boundary: computing it, its counts and its records.
//
// An arc has two half-edges, one on each of its balls, and its id is the rank of its lower half-edge among all lower
// ones. As an example the three balls of lib/union/boundary/boundary.hpp, with half-edges 0 and 1 on ball 0, 2 and 3 on
// ball 1, 4 and 5 on ball 2:
//   half-edges of ball 0     both are the lower ones of their arcs: arcs 0 and 1, with balls 1 and 2 in some order
//   half-edges of ball 1     one is the twin of one of ball 0, the other one lower than its twin: arc 2, with ball 2
//   half-edges of ball 2     both are twins
#include "hsp_boundary.hpp"
#include "boundary_records.hpp"
#include "compute_from.hpp"
#include "measure/boundary_metric_check.hpp"

using namespace hsp::capi;

namespace {

// Calls visit(arc, half_edge, twin) for every arc, in the order of their ids.
template <class Visit>
void for_each_arc(const hsp::Boundary &boundary, Visit visit) {
  uint32_t arc = 0;
  for (uint32_t half_edge = 0; half_edge < boundary.half_edge_count(); ++half_edge) {
    const uint32_t twin = boundary.twin(half_edge);
    if (half_edge < twin) visit(arc++, half_edge, twin);
  }
}

// All records, each with its balls in the caller's order.
struct Listing {
  explicit Listing(const hsp_boundary &handle) : boundary(handle.structure()), balls(handle.balls()) {}

  uint32_t vertices() const { return boundary.vertex_count(); }
  uint32_t arcs() const { return boundary.arc_count(); }
  uint32_t circles() const { return boundary.circle_count(); }
  uint32_t loops() const { return boundary.loop_count(); }
  static bool lists_vertex(uint32_t) { return true; }
  static bool lists_circle(uint32_t) { return true; }
  hsp::OrderedVertex in_order(const hsp::VertexRecord &vertex) const {
    return hsp::in_order(vertex, [this](uint32_t a, uint32_t b) { return balls.given_before(a, b); });
  }
  template <class Visit>
  void for_each_arc(Visit visit) const {
    ::for_each_arc(boundary, [&](uint32_t, uint32_t half_edge, uint32_t twin) {
      const uint32_t own = side(boundary.ball_of(half_edge), boundary.ball_of(twin)) == 0 ? half_edge : twin;
      visit(boundary.ball_of(own), own);
    });
  }
  // Which of the two balls comes first in the caller's order: 0 if it is `ball`, else 1.
  uint32_t side(uint32_t ball, uint32_t other) const { return balls.given_before(ball, other) ? 0 : 1; }
  uint32_t ball(uint32_t grid_ball) const { return balls.caller[grid_ball]; }
  template <class Record>
  static uint32_t *balls_of(Record &record) {
    return record.ball;
  }
  static uint32_t vertex(uint32_t id) { return id; }
  static uint32_t face(uint32_t id) { return id; }
  uint32_t face_across(uint32_t, uint32_t half_edge) const { return boundary.face_of(boundary.twin(half_edge)); }
  uint32_t face_across(hsp::ClosedHalfEdge own) const {
    return boundary.face_of_loop(boundary.circle(own.circle()).loop[1 - own.side()]);
  }
  static uint32_t circle(hsp::ClosedHalfEdge own) { return own.circle(); }
  static constexpr hsp_loop no_loop{0, HSP_NONE, 0, 0, 0};
  // The angle of the half-edge with the lower id of both, so that both have the same.
  double angle(uint32_t, uint32_t half_edge) const {
    const uint32_t twin = boundary.twin(half_edge);
    return hsp::angle_of_arc(balls, boundary, half_edge < twin ? half_edge : twin);
  }
  void put_position(const hsp::Position &position, double (&xyz)[3]) const {
    hsp::to_coordinates(balls, position, xyz);
  }
  static void put_direction(const hsp::Vec3 &direction, double (&xyz)[3]) { to_array(direction, xyz); }
  double length(double steps) const { return balls.lattice.length(steps); }

  const hsp::Boundary &boundary;
  const hsp::BallSet &balls;
};

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_boundary);

int32_t hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model, hsp_boundary_limits *limits) {
  return hsp_boundary_compute_with(boundary, model, nullptr, limits);
}

int32_t hsp_boundary_compute_with(hsp_boundary *boundary, const hsp_model *model, const hsp_boundary_request *request,
                                  hsp_boundary_limits *limits) {
  const auto build = [&](const hsp_boundary_request &asked, Executor &executor) {
    boundary->model.set(model);
    boundary->of_some = asked.selected != nullptr;
    return boundary->builder.build(model->grid, executor, asked.selected);
  };
  return compute_from(boundary, model, request, limits, build);
}

int32_t hsp_boundary_get_counts(const hsp_boundary *boundary, hsp_boundary_counts *counts) {
  if (const int32_t status = check_results(boundary, counts == nullptr); status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  *counts = {};
  counts->balls = structure.ball_count();
  counts->vertices = structure.vertex_count();
  counts->arcs = structure.arc_count();
  counts->circles = structure.circle_count();
  counts->faces = structure.face_count();
  counts->loops = structure.loop_count();
  counts->shells = structure.shell_count();
  // Each ball and vertex is looked at here, and not at the end of each computation, as few callers ask for counts.
  for (uint32_t i = 0; i < counts->balls; ++i) {
    counts->contained_balls += structure.is_contained(i) ? 1U : 0U;
    counts->exposed_balls += structure.is_exposed(i) ? 1U : 0U;
  }
  counts->components = structure.component_count();
  counts->voids = counts->shells - counts->components;
  for (uint32_t v = 0; v < counts->vertices; ++v) counts->tied_vertices += structure.vertex(v).tied() ? 1U : 0U;
  counts->euler = structure.euler();
  return HSP_OK;
}

int32_t hsp_boundary_get_vertices(const hsp_boundary *boundary, hsp_vertex *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_records(boundary, out, capacity, needed, &Listing::vertices,
                      [out](const Listing &l) { put_vertices(l, out); });
}

int32_t hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_records(boundary, out, capacity, needed, &Listing::arcs, [out](const Listing &l) { put_arcs(l, out); });
}

int32_t hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_records(boundary, out, capacity, needed, &Listing::circles,
                      [out](const Listing &l) { put_circles(l, out); });
}

int32_t hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status =
      check_request(boundary, out, capacity, needed, [](const hsp_boundary &b) { return b.structure().face_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::BallSet &balls = boundary->balls();
  for (uint32_t f = 0; f < structure.face_count(); ++f) {
    const hsp::IdRange loops = structure.loops_of_face(f);
    out[f] = {balls.caller[structure.face(f).ball], loops.size(), structure.face(f).shell, loops.first};
  }
  return HSP_OK;
}

int32_t hsp_boundary_get_loops(const hsp_boundary *boundary, hsp_loop *out, uint32_t capacity, uint32_t *needed) {
  return list_records(boundary, out, capacity, needed, &Listing::loops, [out](const Listing &l) { put_loops(l, out); });
}

int32_t hsp_boundary_get_loop_arcs(const hsp_boundary *boundary, hsp_loop_arc *out, uint32_t capacity,
                                   uint32_t *needed) {
  const int32_t status = check_request(boundary, out, capacity, needed,
                                       [](const hsp_boundary &b) { return b.structure().half_edge_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const auto walk_all = [&structure, out](auto visit) {
    uint32_t position = 0;
    for (uint32_t loop = 0; loop < structure.loop_count(); ++loop) {
      for_each_half_edge(structure, loop, [&](uint32_t half_edge) { visit(out[position++], half_edge); });
    }
  };
  // There is no memory for the arc of each half-edge but the output: at first out[e].vertex holds the arc of half-edge
  // e.
  for_each_arc(structure, [out](uint32_t arc, uint32_t half_edge, uint32_t twin) {
    out[half_edge].vertex = arc;
    out[twin].vertex = arc;
  });
  walk_all([out](hsp_loop_arc &record, uint32_t half_edge) { record.arc = out[half_edge].vertex; });
  walk_all([&](hsp_loop_arc &record, uint32_t half_edge) {
    record.side = Listing(*boundary).side(structure.ball_of(half_edge), structure.half_edge(half_edge).circle);
    record.vertex = structure.half_edge(half_edge).vertex;
  });
  return HSP_OK;
}

int32_t hsp_boundary_get_balls(const hsp_boundary *boundary, hsp_ball *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status =
      check_request(boundary, out, capacity, needed, [](const hsp_boundary &b) { return b.balls().n; });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t ball = grid.grid_index(i);
    const hsp::IdRange faces = structure.faces(ball);
    out[i].component = structure.component(ball);
    out[i].faces = faces.size();
    out[i].first_face = faces.empty() ? HSP_NONE : faces.first;
    out[i].flags = structure.is_contained(ball) ? HSP_BALL_CONTAINED : 0;
  }
  return HSP_OK;
}

int32_t hsp_boundary_check(hsp_boundary *boundary, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(boundary, invariant == nullptr || id == nullptr); status != HSP_OK)
    return status;
  const hsp::BallSet &balls = boundary->balls();
  const hsp::Boundary &structure = boundary->structure();
  hsp::BoundaryViolation violation = hsp::check_boundary(balls, structure, boundary->builder.scratch());
  if (violation.invariant == hsp::BoundaryInvariant::none) violation = hsp::check_boundary_metric(balls, structure);
  return report(violation, invariant, id);
}
