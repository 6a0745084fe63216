#include "conversion.hpp"
#include "measure/metric_check.hpp"

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
