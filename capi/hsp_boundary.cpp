#include "conversion.hpp"
#include "measure/areas.hpp"
#include "measure/positions.hpp"
#include "sphere/arc_geometry.hpp"

namespace {

using hsp::capi::check_request;
using hsp::capi::has_results;

int32_t check_limits(const hsp_boundary_limits *limits) {
  if (limits == nullptr || limits->struct_size != sizeof(hsp_boundary_limits) || limits->reserved != 0) {
    return HSP_E_ARGUMENT;
  }
  const bool representable = limits->balls <= HSP_MAX_BALLS && limits->neighbours <= HSP_MAX_BALLS &&
                             limits->vertices <= HSP_MAX_BALLS && limits->circles <= HSP_MAX_BALLS;
  return representable ? HSP_OK : HSP_E_RANGE;
}

hsp_boundary *carve(hsp::Workspace &workspace, const hsp::BoundaryLimits &limits, hsp::BoundaryBuilder &builder) {
  const hsp::Span<hsp_boundary> handle = workspace.take<hsp_boundary>(1);
  builder.carve(workspace, limits);
  return handle.data();
}

hsp::BoundaryLimits from_c(const hsp_boundary_limits &limits) {
  return {limits.balls, limits.neighbours, limits.vertices, limits.circles};
}

// The caller's indices of a vertex's balls, ascending, and the sign in that order: each exchange turns it.
struct CallerVertex {
  uint32_t ball[3];
  int32_t sign;
};
CallerVertex to_caller(const hsp::BallSet &balls, const hsp::VertexRecord &vertex) {
  CallerVertex result{{balls.caller[vertex.ball[0]], balls.caller[vertex.ball[1]], balls.caller[vertex.ball[2]]},
                      vertex.positive() ? 1 : -1};
  const auto order = [&result](int a, int b) {
    if (result.ball[a] < result.ball[b]) return;
    const uint32_t larger = result.ball[a];
    result.ball[a] = result.ball[b];
    result.ball[b] = larger;
    result.sign = -result.sign;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return result;
}

}  // namespace

int32_t hsp_boundary_limits_init(hsp_boundary_limits *limits, uint32_t struct_size, uint32_t balls) {
  if (limits == nullptr || struct_size != sizeof(hsp_boundary_limits)) return HSP_E_ARGUMENT;
  if (balls > (HSP_MAX_BALLS - 64) / 8) return HSP_E_RANGE;
  *limits = {struct_size, balls, balls < 256 ? balls : 256, 8 * balls + 64, 2 * balls + 16, 0};
  return HSP_OK;
}

int32_t hsp_boundary_bytes(const hsp_boundary_limits *limits, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_limits(limits); status != HSP_OK) return status;
  hsp::Workspace measure;
  hsp::BoundaryBuilder builder;
  carve(measure, from_c(*limits), builder);
  if (measure.bytes() == 0) return HSP_E_RANGE;
  *bytes = measure.bytes();
  return HSP_OK;
}

int32_t hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits, hsp_boundary **boundary) {
  if (memory == nullptr || boundary == nullptr) return HSP_E_ARGUMENT;
  size_t required = 0;
  if (const int32_t status = hsp_boundary_bytes(limits, &required); status != HSP_OK) return status;
  if (bytes < required) return HSP_E_MEMORY;
  hsp::Workspace workspace(memory, bytes);
  hsp::BoundaryBuilder builder;
  hsp_boundary *handle = carve(workspace, from_c(*limits), builder);
  *handle = {builder, nullptr, 0, 0, false, false};
  *boundary = handle;
  return HSP_OK;
}

int32_t hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model) {
  if (boundary == nullptr) return HSP_E_ARGUMENT;
  hsp::capi::forget(*boundary);
  if (model == nullptr) return HSP_E_ARGUMENT;
  const hsp::Status status = boundary->builder.build(model->grid);
  boundary->model = model;
  boundary->revision = model->revision;
  ++boundary->computed;
  return hsp::capi::remember(*boundary, status);
}

int32_t hsp_boundary_get_needed(const hsp_boundary *boundary, hsp_boundary_limits *needed) {
  if (boundary == nullptr || needed == nullptr) return HSP_E_ARGUMENT;
  if (!boundary->attempted) return HSP_E_STATE;
  const hsp::BoundaryLimits &limits = boundary->builder.needed();
  *needed = {sizeof(hsp_boundary_limits), limits.balls, limits.neighbours, limits.vertices, limits.circles, 0};
  return HSP_OK;
}

int32_t hsp_boundary_get_counts(const hsp_boundary *boundary, hsp_boundary_counts *counts) {
  if (boundary == nullptr || counts == nullptr) return HSP_E_ARGUMENT;
  if (!has_results(*boundary)) return HSP_E_STATE;
  const hsp::Boundary &structure = boundary->builder.boundary();
  const uint32_t n = boundary->model->grid.balls().n;
  *counts = {};
  counts->balls = n;
  counts->vertices = structure.vertex_count();
  counts->arcs = 3 * counts->vertices / 2;
  counts->circles = structure.circle_count();
  counts->faces = structure.face_count();
  counts->loops = structure.loop_count();
  counts->shells = structure.shell_count();
  for (uint32_t i = 0; i < n; ++i) {
    counts->contained_balls += structure.is_contained(i) ? 1U : 0U;
    counts->exposed_balls += structure.is_exposed(i) ? 1U : 0U;
  }
  counts->components = structure.component_count();
  counts->voids = counts->shells - counts->components;
  for (uint32_t v = 0; v < counts->vertices; ++v) counts->tied_vertices += structure.vertex(v).tied() ? 1U : 0U;
  counts->euler = static_cast<int64_t>(counts->vertices) - static_cast<int64_t>(counts->arcs) +
                  2 * static_cast<int64_t>(counts->faces) - static_cast<int64_t>(counts->loops);
  return HSP_OK;
}

int32_t hsp_boundary_get_vertices(const hsp_boundary *boundary, hsp_vertex *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(boundary, out, capacity, needed,
                                       [](const hsp_boundary &b) { return b.builder.boundary().vertex_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->builder.boundary();
  const hsp::BallSet &balls = boundary->model->grid.balls();
  for (uint32_t v = 0; v < structure.vertex_count(); ++v) {
    const hsp::VertexRecord &vertex = structure.vertex(v);
    const CallerVertex named = to_caller(balls, vertex);
    hsp_vertex &record = out[v];
    hsp::capi::to_position(balls, hsp::position_of_vertex(balls, structure, v), record.xyz);
    for (int t = 0; t < 3; ++t) record.ball[t] = named.ball[t];
    record.sign = named.sign;
    record.flags = vertex.tied() ? HSP_VERTEX_TIED : 0;
    record.reserved = 0;
  }
  return HSP_OK;
}

int32_t hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(boundary, out, capacity, needed, [](const hsp_boundary &b) {
    return b.builder.boundary().half_edge_count() / 2;
  });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->builder.boundary();
  const hsp::BallSet &balls = boundary->model->grid.balls();
  const uint32_t half_edges = structure.half_edge_count();
  uint32_t written = 0;
  for (uint32_t half_edge = 0; half_edge < half_edges; ++half_edge) {
    const uint32_t twin = structure.twin(half_edge);
    if (twin < half_edge) continue;
    const uint32_t own = structure.ball_of(half_edge);
    const uint32_t other = structure.half_edge(half_edge).circle;
    // A loop walks clockwise about the axis away from its own ball; the twin walks the same arc backwards,
    // counter-clockwise about the axis that leaves this ball. So as seen from ball a the arc starts where its own walk
    // ends.
    const bool own_first = balls.caller[own] < balls.caller[other];
    const uint32_t walk_of_a = own_first ? half_edge : twin;
    const uint32_t walk_of_b = own_first ? twin : half_edge;
    const bool own_lower = hsp::exact::ranks_before(balls.ball(own), balls.ball(other));
    hsp_arc &arc = out[written++];
    arc.ball[0] = balls.caller[own_first ? own : other];
    arc.ball[1] = balls.caller[own_first ? other : own];
    arc.vertex[0] = structure.half_edge(structure.half_edge(walk_of_a).next).vertex;
    arc.vertex[1] = structure.half_edge(walk_of_a).vertex;
    arc.face[0] = structure.face_of_loop(structure.half_edge(walk_of_a).loop);
    arc.face[1] = structure.face_of_loop(structure.half_edge(walk_of_b).loop);
    // Computed from the ball of lower rank, so that ids have no effect on it.
    arc.angle = hsp::angle_of(balls, structure, own_lower ? own : other, own_lower ? half_edge : twin);
  }
  return HSP_OK;
}

int32_t hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(boundary, out, capacity, needed,
                                       [](const hsp_boundary &b) { return b.builder.boundary().circle_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->builder.boundary();
  const hsp::BallSet &balls = boundary->model->grid.balls();
  for (uint32_t c = 0; c < structure.circle_count(); ++c) {
    const hsp::CircleRecord &circle = structure.circle(c);
    const uint32_t first = balls.caller[circle.ball[0]] < balls.caller[circle.ball[1]] ? 0 : 1;
    hsp_circle &record = out[c];
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t k = side == 0 ? first : 1 - first;
      record.ball[side] = balls.caller[circle.ball[k]];
      record.face[side] = structure.face_of_loop(circle.loop[k]);
    }
    const bool swap = hsp::exact::ranks_before(balls.ball(circle.ball[1]), balls.ball(circle.ball[0]));
    const uint32_t lower = circle.ball[swap ? 1 : 0];
    const uint32_t higher = circle.ball[swap ? 0 : 1];
    const hsp::CircleGeometry geometry(balls, lower, higher);
    const double direction = circle.ball[first] == lower ? 1.0 : -1.0;
    hsp::capi::to_position(balls, {lower, geometry.centre}, record.centre);
    hsp::capi::to_array(direction * geometry.axis, record.axis);
    record.radius = balls.lattice.length(geometry.radius);
  }
  return HSP_OK;
}

int32_t hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(boundary, out, capacity, needed,
                                       [](const hsp_boundary &b) { return b.builder.boundary().face_count(); });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->builder.boundary();
  const hsp::BallSet &balls = boundary->model->grid.balls();
  for (uint32_t f = 0; f < structure.face_count(); ++f) {
    out[f] = {balls.caller[structure.face(f).ball], structure.face(f).loops, structure.face(f).shell, 0};
  }
  return HSP_OK;
}

int32_t hsp_boundary_get_balls(const hsp_boundary *boundary, hsp_ball *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status =
      check_request(boundary, out, capacity, needed, [](const hsp_boundary &b) { return b.model->grid.balls().n; });
  if (status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->builder.boundary();
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
