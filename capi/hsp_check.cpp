#include "conversion.hpp"
#include "measure/boundary_metric_check.hpp"
#include "measure/shell_volumes.hpp"

namespace {

using hsp::BoundaryInvariant;
using hsp::TopologyInvariant;

constexpr uint32_t to_c(BoundaryInvariant law) {
  return static_cast<uint32_t>(law);
}
constexpr uint32_t to_c(TopologyInvariant law) {
  return static_cast<uint32_t>(law);
}

// The numbers that the header gives the laws of hsp_boundary_check.
static_assert(to_c(BoundaryInvariant::none) == 0);
static_assert(to_c(BoundaryInvariant::vertices) == 1 && to_c(BoundaryInvariant::half_edges) == 2);
static_assert(to_c(BoundaryInvariant::successors) == 3 && to_c(BoundaryInvariant::twins) == 4);
static_assert(to_c(BoundaryInvariant::loops) == 5 && to_c(BoundaryInvariant::faces) == 6);
static_assert(to_c(BoundaryInvariant::shells) == 7 && to_c(BoundaryInvariant::euler) == 8);
static_assert(to_c(BoundaryInvariant::positions) == 9 && to_c(BoundaryInvariant::areas) == 10);
static_assert(to_c(BoundaryInvariant::closure) == 11);

// And those of hsp_topology_check.
static_assert(to_c(TopologyInvariant::none) == 0);
static_assert(to_c(TopologyInvariant::algebra) == 1 && to_c(TopologyInvariant::vertices) == 2);
static_assert(to_c(TopologyInvariant::faces) == 3 && to_c(TopologyInvariant::sides) == 4);
static_assert(to_c(TopologyInvariant::euler) == 5 && to_c(TopologyInvariant::traversal) == 6);
static_assert(to_c(TopologyInvariant::cells) == 7 && to_c(TopologyInvariant::volumes) == 8);

}  // namespace

int32_t hsp_boundary_check(hsp_boundary *boundary, uint32_t *law, uint32_t *where) {
  if (boundary == nullptr || law == nullptr || where == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*boundary)) return HSP_E_STATE;
  const hsp::BallSet &balls = boundary->model->grid.balls();
  const hsp::Boundary &structure = boundary->builder.boundary();
  hsp::Violation violation = hsp::check_boundary(balls, structure, boundary->builder.scratch());
  if (violation.invariant == hsp::BoundaryInvariant::none) violation = hsp::check_boundary_metric(balls, structure);
  *law = to_c(violation.invariant);
  *where = violation.id;
  return violation.invariant == hsp::BoundaryInvariant::none ? HSP_OK : HSP_E_CHECK;
}

int32_t hsp_topology_check(hsp_topology *topology, uint32_t *law, uint32_t *where) {
  if (topology == nullptr || law == nullptr || where == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*topology)) return HSP_E_STATE;
  const hsp::BallSet &balls = topology->boundary->model->grid.balls();
  const hsp::Boundary &boundary = topology->boundary->builder.boundary();
  const hsp::Topology &structure = topology->builder.structure();
  hsp::TopologyViolation violation = hsp::check_topology(boundary, structure, topology->builder.marks());
  if (violation.invariant == hsp::TopologyInvariant::none)
    violation = hsp::check_enclosed_volumes(balls, boundary, structure);
  *law = to_c(violation.invariant);
  *where = violation.id;
  return violation.invariant == hsp::TopologyInvariant::none ? HSP_OK : HSP_E_CHECK;
}
