#include "hsp_topology.hpp"
#include "topology/positions.hpp"

namespace {

using namespace hsp::capi;

// Records of a topology with results.
struct TopologyResults {
  const hsp::BallSet &balls;
  const hsp::Boundary &boundary;
  const hsp::Topology &topology;

  explicit TopologyResults(const hsp_topology &handle)
      : balls(handle.boundary->balls()), boundary(handle.boundary->structure()), topology(handle.structure()) {}
};

hsp_topology_vertex topology_vertex(const TopologyResults &results, uint32_t id) {
  hsp_topology_vertex record{};
  hsp::to_coordinates(results.balls, hsp::position_of_point(results.balls, results.boundary, results.topology, id),
                      record.xyz);
  const auto caller = [&results](uint32_t ball) { return results.balls.caller[ball]; };
  record.q = results.topology.vertex_edge[id];
  for (uint32_t &ball : record.ball) ball = HSP_NONE;
  const uint32_t own_vertices = results.boundary.vertex_count();
  if (id < own_vertices) {
    record.kind = HSP_POINT_VERTEX;
    const hsp::OrderedVertex vertex = hsp::in_order(
        results.boundary.vertex(id), [&results](uint32_t a, uint32_t b) { return results.balls.given_before(a, b); });
    for (int t = 0; t < 3; ++t) record.ball[t] = caller(vertex.ball[t]);
  } else if (id < results.topology.first_pole) {
    record.kind = HSP_POINT_CIRCLE;
    const hsp::HostBalls pair =
        hsp::balls_of_host(results.boundary, results.topology.subdivision_vertex(results.boundary, id).host);
    const bool first = results.balls.given_before(pair.a, pair.b);
    record.ball[0] = caller(first ? pair.a : pair.b);
    record.ball[1] = caller(first ? pair.b : pair.a);
  } else {
    record.kind = HSP_POINT_POLE;
    record.ball[0] = caller(results.topology.pole_at(id).ball());
  }
  return record;
}

hsp_topology_edge topology_edge(const TopologyResults &results, uint32_t id) {
  hsp_topology_edge record{};
  const hsp::EdgeGeometry geometry = hsp::geometry_of_edge(results.balls, results.boundary, results.topology, id);
  hsp::to_coordinates(results.balls, geometry.centre, record.centre);
  to_array(geometry.axis, record.axis);
  record.radius = results.balls.lattice.length(geometry.radius);
  record.angle = geometry.angle;
  const uint32_t q = hsp::quarter_edge(id);
  for (uint32_t side = 0; side < 2; ++side) {
    const uint32_t directed = side == 0 ? q : hsp::sym(q);
    record.vertex[side] = results.topology.quads.origin(directed);
    record.face[side] = results.topology.quads.left(directed);
    record.ball[side] = results.balls.caller[results.topology.ball_of(results.boundary, record.face[side])];
  }
  if (id >= results.topology.first_cut_edge) {
    record.kind = HSP_EDGE_CUT;
    record.source = HSP_NONE;
  } else if (id >= results.topology.first_circle_edge) {
    record.kind = HSP_EDGE_CIRCLE;
    record.source = hsp::Subdivision::circle_of(results.boundary, results.topology.edge_source[id]);
  } else {
    record.kind = HSP_EDGE_ARC;
    record.source = results.topology.edge_source[id];
  }
  return record;
}

hsp_simple_face topology_face(const TopologyResults &results, uint32_t id) {
  const hsp::SimpleFace &face = results.topology.faces[id];
  return {results.balls.caller[results.topology.ball_of(results.boundary, id)],
          face.face,
          face.edges,
          face.q,
          results.topology.shell_of(results.boundary, id),
          0};
}

// Records first .. first + count - 1.
template <class Record, class Number, class Make>
int32_t get_topology_range(const hsp_topology *topology, uint32_t first, uint32_t count, Record *out, Number number,
                           Make make) {
  const int32_t status = check_range(topology, first, count, out, number);
  if (status != HSP_OK) return status;
  const TopologyResults results(*topology);
  for (uint32_t k = 0; k < count; ++k) out[k] = make(results, first + k);
  return HSP_OK;
}

}  // namespace

int32_t hsp_topology_get_vertices(const hsp_topology *topology, uint32_t first, uint32_t count,
                                  hsp_topology_vertex *out) {
  LibraryArithmetic arithmetic;
  const auto vertices = [](const hsp_topology &handle) { return handle.structure().vertex_count; };
  return get_topology_range(topology, first, count, out, vertices, topology_vertex);
}

int32_t hsp_topology_get_edges(const hsp_topology *topology, uint32_t first, uint32_t count, hsp_topology_edge *out) {
  LibraryArithmetic arithmetic;
  const auto edges = [](const hsp_topology &handle) { return handle.structure().quads.edges; };
  return get_topology_range(topology, first, count, out, edges, topology_edge);
}

int32_t hsp_topology_get_simple_faces(const hsp_topology *topology, uint32_t first, uint32_t count,
                                      hsp_simple_face *out) {
  const auto faces = [](const hsp_topology &handle) { return handle.structure().face_count; };
  return get_topology_range(topology, first, count, out, faces, topology_face);
}

int32_t hsp_topology_get_traversal(const hsp_topology *topology, uint32_t shell, uint32_t *faces, uint32_t capacity,
                                   uint32_t *needed) {
  if (const int32_t status = check_results(topology, faces == nullptr && capacity > 0); status != HSP_OK) return status;
  const hsp::Topology &structure = topology->structure();
  if (shell >= structure.shell_count) return HSP_E_ID;
  const hsp::ShellRecord &record = structure.shells[shell];
  if (check_output(capacity, record.simple_faces, needed) != HSP_OK) return HSP_E_CAPACITY;
  for (uint32_t k = 0; k < record.simple_faces; ++k) faces[k] = structure.traversal[record.first_traversed + k];
  return HSP_OK;
}
