#include "conversion.hpp"
#include "measure/boundary_metric_check.hpp"
#include "measure/shell_volumes.hpp"

namespace {

using hsp::BoundaryLaw;
using hsp::TopologyLaw;

constexpr uint32_t to_c(BoundaryLaw law) {
  return static_cast<uint32_t>(law);
}
constexpr uint32_t to_c(TopologyLaw law) {
  return static_cast<uint32_t>(law);
}

// The numbers that the header gives the laws of hsp_boundary_check.
static_assert(to_c(BoundaryLaw::none) == 0);
static_assert(to_c(BoundaryLaw::vertices) == 1 && to_c(BoundaryLaw::uses) == 2);
static_assert(to_c(BoundaryLaw::successors) == 3 && to_c(BoundaryLaw::twins) == 4);
static_assert(to_c(BoundaryLaw::loops) == 5 && to_c(BoundaryLaw::faces) == 6);
static_assert(to_c(BoundaryLaw::shells) == 7 && to_c(BoundaryLaw::euler) == 8);
static_assert(to_c(BoundaryLaw::positions) == 9 && to_c(BoundaryLaw::areas) == 10);
static_assert(to_c(BoundaryLaw::closure) == 11);

// And those of hsp_topology_check.
static_assert(to_c(TopologyLaw::none) == 0);
static_assert(to_c(TopologyLaw::algebra) == 1 && to_c(TopologyLaw::vertices) == 2);
static_assert(to_c(TopologyLaw::faces) == 3 && to_c(TopologyLaw::sides) == 4);
static_assert(to_c(TopologyLaw::euler) == 5 && to_c(TopologyLaw::scan) == 6);
static_assert(to_c(TopologyLaw::cells) == 7 && to_c(TopologyLaw::volumes) == 8);

}  // namespace

int32_t hsp_boundary_check(hsp_boundary *boundary, uint32_t *law, uint32_t *where) {
  if (boundary == nullptr || law == nullptr || where == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*boundary)) return HSP_E_STATE;
  const hsp::BallSet &balls = boundary->model->grid.balls();
  const hsp::BoundaryStructure &structure = boundary->builder.structure();
  hsp::Violation violation = hsp::check_structure(balls, structure);
  if (violation.law == hsp::BoundaryLaw::none) violation = hsp::check_metric(balls, structure);
  *law = to_c(violation.law);
  *where = violation.where;
  return violation.law == hsp::BoundaryLaw::none ? HSP_OK : HSP_E_CHECK;
}

int32_t hsp_topology_check(hsp_topology *topology, uint32_t *law, uint32_t *where) {
  if (topology == nullptr || law == nullptr || where == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*topology)) return HSP_E_STATE;
  const hsp::BallSet &balls = topology->boundary->model->grid.balls();
  const hsp::BoundaryStructure &boundary = topology->boundary->builder.structure();
  const hsp::TopologyStructure &structure = topology->builder.structure();
  hsp::TopologyViolation violation = hsp::check_topology(boundary, structure, topology->builder.marks());
  if (violation.law == hsp::TopologyLaw::none) violation = hsp::check_enclosed_volumes(balls, boundary, structure);
  *law = to_c(violation.law);
  *where = violation.where;
  return violation.law == hsp::TopologyLaw::none ? HSP_OK : HSP_E_CHECK;
}
