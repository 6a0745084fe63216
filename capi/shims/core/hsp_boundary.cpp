#include "hsp_boundary.hpp"
#include "caller_executor.hpp"
#include "loop_walk.hpp"
#include "measure/boundary_metric_check.hpp"
#include "measure/boundary_positions.hpp"

using hsp::capi::check_handle;
using hsp::capi::check_results;
using hsp::capi::check_struct;
using hsp::capi::first_failure;
using hsp::capi::LibraryArithmetic;

namespace {

using hsp::capi::check_request;
using hsp::capi::for_each_half_edge;

constexpr uint32_t number_of(hsp::BoundaryInvariant invariant) {
  return static_cast<uint32_t>(invariant);
}

// The numbers that the header gives the invariants of hsp_boundary_check.
using hsp::BoundaryInvariant;
static_assert(number_of(BoundaryInvariant::none) == 0);
static_assert(number_of(BoundaryInvariant::vertices) == 1 && number_of(BoundaryInvariant::half_edges) == 2);
static_assert(number_of(BoundaryInvariant::successors) == 3 && number_of(BoundaryInvariant::twins) == 4);
static_assert(number_of(BoundaryInvariant::loops) == 5 && number_of(BoundaryInvariant::faces) == 6);
static_assert(number_of(BoundaryInvariant::shells) == 7 && number_of(BoundaryInvariant::euler) == 8);
static_assert(number_of(BoundaryInvariant::positions) == 9 && number_of(BoundaryInvariant::areas) == 10);
static_assert(number_of(BoundaryInvariant::closure) == 11);

// Calls visit(arc, half_edge, twin) for every arc, in the order of their ids.
template <class Visit>
void for_each_arc(const hsp::Boundary &boundary, Visit visit) {
  uint32_t arc = 0;
  for (uint32_t half_edge = 0; half_edge < boundary.half_edge_count(); ++half_edge) {
    const uint32_t twin = boundary.twin(half_edge);
    if (half_edge < twin) visit(arc++, half_edge, twin);
  }
}

// Which of two balls a < b of the caller's order `ball` is: 0 or 1.
uint32_t side_of(const hsp::BallSet &balls, uint32_t ball, uint32_t other) {
  return balls.given_before(ball, other) ? 0 : 1;
}

// Common to arcs and circles: the circle of balls a and b.
template <class Record>
void write_circle(const hsp::BallSet &balls, uint32_t a, uint32_t b, Record &record) {
  const hsp::CirclePosition position = hsp::position_of_circle(balls, a, b);
  hsp::to_coordinates(balls, position.centre, record.centre);
  hsp::capi::to_array(position.axis, record.axis);
  record.radius = balls.lattice.length(position.radius);
  record.ball[0] = balls.caller[a];
  record.ball[1] = balls.caller[b];
}

}  // namespace

int32_t hsp_boundary_limits_init(hsp_boundary_limits *limits, uint32_t struct_size, uint32_t balls) {
  return hsp::capi::init_limits<hsp_boundary>(limits, struct_size, balls);
}

int32_t hsp_boundary_bytes(const hsp_boundary_limits *limits, size_t *bytes) {
  return hsp::capi::get_bytes_by_limits<hsp_boundary>(limits, bytes);
}

int32_t hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits, hsp_boundary **boundary) {
  return hsp::capi::init_by_limits(memory, bytes, limits, boundary);
}

int32_t hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model, hsp_boundary_limits *limits) {
  return hsp_boundary_compute_with(boundary, model, nullptr, limits);
}

int32_t hsp_boundary_compute_with(hsp_boundary *boundary, const hsp_model *model, const hsp_boundary_request *request,
                                  hsp_boundary_limits *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return status;
  boundary->complete = false;
  hsp_boundary_request asked;
  hsp::capi::Executor executor(arithmetic);
  if (const int32_t status =
          first_failure(check_handle(model), check_struct(limits), hsp::capi::read_request(request, asked, executor));
      status != HSP_OK)
    return status;
  if (!model->has_results()) return HSP_E_STATE;
  boundary->model.set(model);
  boundary->of_some = asked.selected != nullptr;
  return hsp::capi::finish(*boundary, boundary->builder.build(model->grid, executor, asked.selected), limits);
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
  const int32_t status = check_request(boundary, out, capacity, needed,
                                       [](const hsp_boundary &b) { return b.structure().vertex_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::BallSet &balls = boundary->balls();
  const auto given_before = [&balls](uint32_t a, uint32_t b) { return balls.given_before(a, b); };
  for (uint32_t v = 0; v < structure.vertex_count(); ++v) {
    const hsp::OrderedVertex vertex = hsp::in_order(structure.vertex(v), given_before);
    hsp_vertex &record = out[v];
    hsp::to_coordinates(balls, hsp::position_of_vertex(balls, structure, v), record.xyz);
    for (int t = 0; t < 3; ++t) record.ball[t] = balls.caller[vertex.ball[t]];
    record.sign = vertex.sign;
    record.flags = structure.vertex(v).tied() ? HSP_VERTEX_TIED : 0;
    record.reserved = 0;
  }
  return HSP_OK;
}

int32_t hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_request(boundary, out, capacity, needed, [](const hsp_boundary &b) { return b.structure().arc_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::BallSet &balls = boundary->balls();
  for_each_arc(structure, [&](uint32_t id, uint32_t half_edge, uint32_t twin) {
    const bool own_first = side_of(balls, structure.ball_of(half_edge), structure.ball_of(twin)) == 0;
    const uint32_t a = own_first ? half_edge : twin;
    const uint32_t b = own_first ? twin : half_edge;
    hsp_arc &arc = out[id];
    write_circle(balls, structure.ball_of(a), structure.ball_of(b), arc);
    // A half-edge runs clockwise about the axis away from its own ball, the arc counter-clockwise about that away from
    // ball a: so it starts where the half-edge on a ends.
    arc.vertex[0] = structure.end_vertex(a);
    arc.vertex[1] = structure.half_edge(a).vertex;
    arc.face[0] = structure.face_of(a);
    arc.face[1] = structure.face_of(b);
    arc.angle = hsp::angle_of_arc(balls, structure, half_edge);
  });
  return HSP_OK;
}

int32_t hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(boundary, out, capacity, needed,
                                       [](const hsp_boundary &b) { return b.structure().circle_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::BallSet &balls = boundary->balls();
  for (uint32_t c = 0; c < structure.circle_count(); ++c) {
    const hsp::CircleRecord &circle = structure.circle(c);
    const uint32_t a = side_of(balls, circle.ball[0], circle.ball[1]);
    write_circle(balls, circle.ball[a], circle.ball[1 - a], out[c]);
    out[c].face[0] = structure.face_of_loop(circle.loop[a]);
    out[c].face[1] = structure.face_of_loop(circle.loop[1 - a]);
  }
  return HSP_OK;
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
  const int32_t status =
      check_request(boundary, out, capacity, needed, [](const hsp_boundary &b) { return b.structure().loop_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  uint32_t first_arc = 0;
  for (uint32_t loop = 0; loop < structure.loop_count(); ++loop) {
    const hsp::LoopElement start = structure.loop_start(loop);
    hsp_loop &record = out[loop];
    record = {structure.face_of_loop(loop), HSP_NONE, 0, first_arc, 0};
    if (start.is_circle()) {
      const hsp::ClosedHalfEdge circle = start.closed_half_edge();
      record.circle = circle.circle();
      record.side = side_of(boundary->balls(), structure.ball_of(circle), structure.neighbour(circle));
    }
    for_each_half_edge(structure, loop, [&](uint32_t) { ++record.arcs; });
    first_arc += record.arcs;
  }
  return HSP_OK;
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
  // No memory but the output tells the arc of a half-edge: out[e].vertex holds that of half-edge e for a while.
  for_each_arc(structure, [out](uint32_t arc, uint32_t half_edge, uint32_t twin) {
    out[half_edge].vertex = arc;
    out[twin].vertex = arc;
  });
  walk_all([out](hsp_loop_arc &record, uint32_t half_edge) { record.arc = out[half_edge].vertex; });
  walk_all([&](hsp_loop_arc &record, uint32_t half_edge) {
    record.side = side_of(boundary->balls(), structure.ball_of(half_edge), structure.half_edge(half_edge).circle);
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
  if (violation.invariant == BoundaryInvariant::none) violation = hsp::check_boundary_metric(balls, structure);
  return hsp::capi::report(violation, invariant, id);
}
