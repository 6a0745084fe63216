#include "conversion.hpp"
#include "topology/simple_faces.hpp"

namespace {

using hsp::capi::check_request;
using hsp::capi::has_results;

int32_t check_limits(const hsp_topology_limits *limits) {
  if (limits == nullptr || limits->struct_size != sizeof(hsp_topology_limits) || limits->reserved != 0) {
    return HSP_E_ARGUMENT;
  }
  const bool representable = limits->balls <= HSP_MAX_BALLS && limits->neighbours <= HSP_MAX_BALLS &&
                             limits->edges <= HSP_MAX_BALLS && limits->cut_arcs <= HSP_MAX_BALLS;
  return representable ? HSP_OK : HSP_E_RANGE;
}

hsp::TopologyLimits from_c(const hsp_topology_limits &limits) {
  return {limits.balls, limits.neighbours, limits.edges, limits.cut_arcs};
}

hsp_topology *carve(hsp::Workspace &workspace, const hsp::TopologyLimits &limits, hsp::TopologyBuilder &builder) {
  const hsp::Span<hsp_topology> handle = workspace.take<hsp_topology>(1);
  builder.carve(workspace, limits);
  return handle.data();
}

// Applies a step of the quad-edge algebra to a quarter-edge that is there.
template <class Step>
uint32_t step_from(const hsp_topology *topology, uint32_t q, Step step) {
  if (topology == nullptr || !has_results(*topology)) return HSP_NONE;
  const hsp::QuadEdges &quads = topology->builder.structure().quads;
  return q / 4 < quads.edges ? step(quads) : HSP_NONE;
}

}  // namespace

int32_t hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size, uint32_t balls) {
  if (limits == nullptr || struct_size != sizeof(hsp_topology_limits)) return HSP_E_ARGUMENT;
  if (balls > (HSP_MAX_BALLS - 96) / 16) return HSP_E_RANGE;
  *limits = {struct_size, balls, balls < 256 ? balls : 256, 16 * balls + 96, 2 * balls + 16, 0};
  return HSP_OK;
}

int32_t hsp_topology_limits_for(hsp_topology_limits *limits, uint32_t struct_size, const hsp_boundary *boundary) {
  if (limits == nullptr || struct_size != sizeof(hsp_topology_limits) || boundary == nullptr) return HSP_E_ARGUMENT;
  if (!has_results(*boundary)) return HSP_E_STATE;
  const hsp::Boundary &structure = boundary->builder.boundary();
  const hsp::BallSet &balls = boundary->model->grid.balls();
  const uint64_t uncut = hsp::count_uncut_edges(balls, structure);
  // A face with several loops needs a cut arc less than it has loops, and gets up to four times as many from great
  // circles that cross it more than once.
  uint64_t extra = 0;
  for (uint32_t f = 0; f < structure.face_count(); ++f) {
    if (structure.face(f).loops > 1) extra += 4 * (static_cast<uint64_t>(structure.face(f).loops) - 1);
  }
  const auto clamp = [](uint64_t wanted) {
    return wanted < HSP_MAX_BALLS ? static_cast<uint32_t>(wanted) : HSP_MAX_BALLS;
  };
  *limits = {struct_size, balls.n, boundary->builder.needed().neighbours, clamp(uncut + 4 * extra), clamp(extra), 0};
  return HSP_OK;
}

int32_t hsp_topology_bytes(const hsp_topology_limits *limits, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_limits(limits); status != HSP_OK) return status;
  hsp::Workspace measure;
  hsp::TopologyBuilder builder;
  carve(measure, from_c(*limits), builder);
  if (measure.bytes() == 0) return HSP_E_RANGE;
  *bytes = measure.bytes();
  return HSP_OK;
}

int32_t hsp_topology_init(void *memory, size_t bytes, const hsp_topology_limits *limits, hsp_topology **topology) {
  if (memory == nullptr || topology == nullptr) return HSP_E_ARGUMENT;
  size_t required = 0;
  if (const int32_t status = hsp_topology_bytes(limits, &required); status != HSP_OK) return status;
  if (bytes < required) return HSP_E_MEMORY;
  hsp::Workspace workspace(memory, bytes);
  hsp::TopologyBuilder builder;
  hsp_topology *handle = carve(workspace, from_c(*limits), builder);
  *handle = {builder, nullptr, 0, false, false};
  *topology = handle;
  return HSP_OK;
}

int32_t hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary) {
  if (topology == nullptr) return HSP_E_ARGUMENT;
  hsp::capi::forget(*topology);
  if (boundary == nullptr) return HSP_E_ARGUMENT;
  if (!has_results(*boundary)) return HSP_E_STATE;
  const hsp::Status status = topology->builder.build(boundary->model->grid, boundary->builder.boundary(),
                                                     boundary->builder.needed().neighbours);
  topology->boundary = boundary;
  topology->computed = boundary->computed;
  return hsp::capi::remember(*topology, status);
}

int32_t hsp_topology_get_needed(const hsp_topology *topology, hsp_topology_limits *needed) {
  if (topology == nullptr || needed == nullptr) return HSP_E_ARGUMENT;
  if (!topology->attempted) return HSP_E_STATE;
  const hsp::TopologyLimits &limits = topology->builder.needed();
  *needed = {sizeof(hsp_topology_limits), limits.balls, limits.neighbours, limits.edges, limits.cut_arcs, 0};
  return HSP_OK;
}

int32_t hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts) {
  if (topology == nullptr || counts == nullptr) return HSP_E_ARGUMENT;
  if (!has_results(*topology)) return HSP_E_STATE;
  const hsp::Topology &structure = topology->builder.structure();
  *counts = {structure.vertex_count, structure.quads.edges,
             structure.face_count,   structure.quads.edges - structure.first_cut_edge,
             structure.shell_count,  structure.component_count,
             structure.cell_count,   structure.start_face};
  return HSP_OK;
}

uint32_t hsp_quad_rot(uint32_t q) {
  return q == HSP_NONE ? HSP_NONE : hsp::rot(q);
}

uint32_t hsp_quad_inverse_rot(uint32_t q) {
  return q == HSP_NONE ? HSP_NONE : hsp::inverse_rot(q);
}

uint32_t hsp_quad_sym(uint32_t q) {
  return q == HSP_NONE ? HSP_NONE : hsp::sym(q);
}

uint32_t hsp_topology_onext(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.onext(q); });
}

uint32_t hsp_topology_oprev(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.oprev(q); });
}

uint32_t hsp_topology_lnext(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.lnext(q); });
}

uint32_t hsp_topology_lprev(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.lprev(q); });
}

uint32_t hsp_topology_origin(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.origin(q); });
}

uint32_t hsp_topology_left(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.left(q); });
}

uint32_t hsp_topology_ball(const hsp_topology *topology, uint32_t q) {
  if (q % 2 != 0) return HSP_NONE;
  return step_from(topology, q, [q, topology](const hsp::QuadEdges &quads) {
    const hsp::Boundary &boundary = topology->boundary->builder.boundary();
    return topology->boundary->model->grid.balls()
        .caller[topology->builder.structure().ball_of(boundary, quads.left(q))];
  });
}

int32_t hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t *onext, uint32_t *origin, uint32_t capacity,
                                    uint32_t *needed) {
  const void *any = onext != nullptr ? onext : origin;
  const int32_t status = check_request(topology, any, capacity, needed, [](const hsp_topology &handle) {
    return handle.builder.structure().quads.edges;
  });
  if (status != HSP_OK) return status;
  const hsp::QuadEdges &quads = topology->builder.structure().quads;
  for (uint32_t q = 0; q < 4 * quads.edges; ++q) {
    if (onext != nullptr) onext[q] = quads.onext(q);
    if (origin != nullptr) origin[q] = quads.origin(q);
  }
  return HSP_OK;
}
