#include "hsp_topology.hpp"
#include "topology/shell_volumes.hpp"

using namespace hsp::capi;

namespace {

// Applies a step of the quad-edge algebra to a quarter-edge that is there.
template <class Step>
uint32_t step_from(const hsp_topology *topology, uint32_t q, Step step) {
  if (!is_live(topology) || !topology->has_results()) return HSP_NONE;
  const hsp::QuadEdges &quads = topology->structure().quads;
  return q / 4 < quads.edges ? step(quads) : HSP_NONE;
}

}  // namespace

uint32_t hsp_topology_onext(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.onext(q); });
}

uint32_t hsp_topology_lnext(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.lnext(q); });
}

uint32_t hsp_topology_origin(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.origin(q); });
}

uint32_t hsp_topology_left(const hsp_topology *topology, uint32_t q) {
  return step_from(topology, q, [q](const hsp::QuadEdges &quads) { return quads.left(q); });
}

int32_t hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t first, uint32_t count, uint32_t *onext,
                                    uint32_t *origin) {
  const int32_t status = check_range(topology, first, count, onext != nullptr ? onext : origin,
                                     [](const hsp_topology &handle) { return handle.structure().quads.edges; });
  if (status != HSP_OK) return status;
  const hsp::QuadEdges &quads = topology->structure().quads;
  const uint32_t first_q = hsp::quarter_edge(first);
  for (uint32_t k = 0; k < 4 * count; ++k) {
    if (onext != nullptr) onext[k] = quads.onext(first_q + k);
    if (origin != nullptr) origin[k] = quads.origin(first_q + k);
  }
  return HSP_OK;
}

int32_t hsp_topology_check(hsp_topology *topology, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(topology, invariant == nullptr || id == nullptr); status != HSP_OK)
    return status;
  const hsp::Boundary &boundary = topology->boundary->structure();
  const hsp::Topology &structure = topology->structure();
  hsp::TopologyViolation violation = hsp::check_topology(boundary, structure, topology->builder.marks());
  if (violation.invariant == hsp::TopologyInvariant::none) {
    violation = hsp::check_enclosed_volumes(topology->balls(), boundary, structure);
  }
  return report(violation, invariant, id);
}
