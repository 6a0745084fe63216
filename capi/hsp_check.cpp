#include "conversion.hpp"
#include "measure/metric_check.hpp"
#include "measure/shell_measures.hpp"

int32_t hsp_boundary_check(hsp_boundary *boundary, uint32_t *law, uint32_t *where) {
  if (boundary == nullptr || law == nullptr || where == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*boundary)) return HSP_E_STATE;
  const hsp::BallSet &balls = boundary->model->grid.balls();
  const hsp::BoundaryStructure &structure = boundary->builder.structure();
  hsp::Violation violation = hsp::check_structure(balls, structure);
  if (violation.law == hsp::BoundaryLaw::none) violation = hsp::check_metric(balls, structure);
  *law = static_cast<uint32_t>(violation.law);
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
  *law = static_cast<uint32_t>(violation.law);
  *where = violation.where;
  return violation.law == hsp::TopologyLaw::none ? HSP_OK : HSP_E_CHECK;
}
