#include "conversion.hpp"

namespace {

using hsp::capi::check_request;
using hsp::capi::has_results;

// The structures behind a topology with results.
struct View {
  const hsp::BallSet &balls;
  const hsp::Boundary &boundary;
  const hsp::Topology &topology;

  explicit View(const hsp_topology &handle)
      : balls(handle.boundary->model->grid.balls()),
        boundary(handle.boundary->builder.boundary()),
        topology(handle.builder.structure()) {}
};

// The caller's indices, ascending; HSP_NONE for balls there are not.
void sort_balls(uint32_t ball[3]) {
  const auto order = [ball](int a, int b) {
    if (ball[a] <= ball[b]) return;
    const uint32_t larger = ball[a];
    ball[a] = ball[b];
    ball[b] = larger;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
}

hsp_topology_vertex vertex_record(const View &view, uint32_t id) {
  hsp_topology_vertex record{};
  hsp::capi::to_position(view.balls, hsp::position_of_point(view.balls, view.boundary, view.topology, id), record.xyz);
  const auto caller = [&view](uint32_t ball) { return view.balls.caller[ball]; };
  record.q = view.topology.vertex_edge[id];
  for (uint32_t &ball : record.ball) ball = HSP_NONE;
  const uint32_t own_vertices = view.boundary.vertex_count();
  if (id < own_vertices) {
    record.kind = HSP_POINT_VERTEX;
    for (int t = 0; t < 3; ++t) record.ball[t] = caller(view.boundary.vertex(id).ball[t]);
  } else if (id < view.topology.first_pole) {
    record.kind = HSP_POINT_CIRCLE;
    const hsp::HostBalls pair = hsp::balls_of_host(view.boundary, view.topology.subdivision[id - own_vertices].host);
    record.ball[0] = caller(pair.a);
    record.ball[1] = caller(pair.b);
  } else {
    record.kind = HSP_POINT_POLE;
    record.ball[0] = caller(view.topology.pole_at(id).ball());
  }
  sort_balls(record.ball);
  return record;
}

hsp_topology_edge edge_record(const View &view, uint32_t id) {
  hsp_topology_edge record{};
  const hsp::EdgeGeometry geometry = hsp::geometry_of_edge(view.balls, view.boundary, view.topology, id);
  hsp::capi::to_position(view.balls, geometry.centre, record.centre);
  hsp::capi::to_array(geometry.axis, record.axis);
  record.radius = view.balls.lattice.length(geometry.radius);
  record.angle = geometry.angle;
  const uint32_t q = hsp::quarter_edge(id);
  for (uint32_t side = 0; side < 2; ++side) {
    const uint32_t directed = side == 0 ? q : hsp::sym(q);
    record.vertex[side] = view.topology.quads.origin(directed);
    record.face[side] = view.topology.quads.left(directed);
    record.ball[side] = view.balls.caller[view.topology.ball_of(view.boundary, record.face[side])];
  }
  if (id >= view.topology.first_cut_edge) {
    record.kind = HSP_EDGE_CUT;
    record.source = HSP_NONE;
  } else if (id >= view.topology.first_circle_edge) {
    record.kind = HSP_EDGE_CIRCLE;
    record.source = hsp::Subdivision::circle_of(view.boundary, view.topology.edge_source[id]);
  } else {
    record.kind = HSP_EDGE_ARC;
    record.source = view.topology.edge_source[id];
  }
  return record;
}

hsp_simple_face face_record(const View &view, uint32_t id) {
  const hsp::SimpleFace &face = view.topology.faces[id];
  return {view.balls.caller[view.topology.ball_of(view.boundary, id)],
          face.face,
          face.edges,
          face.q,
          view.topology.shell_of(view.boundary, id),
          0};
}

// One record by its id.
template <class Record, class Count, class Make>
int32_t get_one(const hsp_topology *topology, uint32_t id, Record *out, Count count, Make make) {
  if (topology == nullptr || out == nullptr) return HSP_E_ARGUMENT;
  if (!has_results(*topology)) return HSP_E_STATE;
  if (id >= count(topology->builder.structure())) return HSP_E_ID;
  *out = make(View(*topology), id);
  return HSP_OK;
}

// All records.
template <class Record, class Count, class Make>
int32_t get_all(const hsp_topology *topology, Record *out, uint32_t capacity, uint32_t *needed, Count count,
                Make make) {
  const int32_t status = check_request(topology, out, capacity, needed, [count](const hsp_topology &handle) {
    return count(handle.builder.structure());
  });
  if (status != HSP_OK) return status;
  const View view(*topology);
  for (uint32_t id = 0; id < *needed; ++id) out[id] = make(view, id);
  return HSP_OK;
}

uint32_t count_vertices(const hsp::Topology &topology) {
  return topology.vertex_count;
}
uint32_t count_edges(const hsp::Topology &topology) {
  return topology.quads.edges;
}
uint32_t count_faces(const hsp::Topology &topology) {
  return topology.face_count;
}

}  // namespace

int32_t hsp_topology_get_vertex(const hsp_topology *topology, uint32_t id, hsp_topology_vertex *out) {
  return get_one(topology, id, out, count_vertices, vertex_record);
}

int32_t hsp_topology_get_edge(const hsp_topology *topology, uint32_t id, hsp_topology_edge *out) {
  return get_one(topology, id, out, count_edges, edge_record);
}

int32_t hsp_topology_get_face(const hsp_topology *topology, uint32_t id, hsp_simple_face *out) {
  return get_one(topology, id, out, count_faces, face_record);
}

int32_t hsp_topology_get_vertices(const hsp_topology *topology, hsp_topology_vertex *out, uint32_t capacity,
                                  uint32_t *needed) {
  return get_all(topology, out, capacity, needed, count_vertices, vertex_record);
}

int32_t hsp_topology_get_edges(const hsp_topology *topology, hsp_topology_edge *out, uint32_t capacity,
                               uint32_t *needed) {
  return get_all(topology, out, capacity, needed, count_edges, edge_record);
}

int32_t hsp_topology_get_faces(const hsp_topology *topology, hsp_simple_face *out, uint32_t capacity,
                               uint32_t *needed) {
  return get_all(topology, out, capacity, needed, count_faces, face_record);
}
