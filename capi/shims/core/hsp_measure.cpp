#include "caller_executor.hpp"
#include "hsp_boundary.hpp"
#include "measure/totals.hpp"

using namespace hsp::capi;

int32_t hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals, double *area,
                             double *volume_term, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(boundary); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const bool wanted = area != nullptr || volume_term != nullptr;
  if (!fits(wanted, capacity, grid.balls().n, needed)) return HSP_E_CAPACITY;
  const hsp::BallMeasure total = hsp::measure_into(grid, boundary->structure(), selected, area, volume_term);
  if (totals != nullptr) *totals = {total.area, total.volume, {0, 0}};
  return HSP_OK;
}

int32_t hsp_boundary_get_measures(const hsp_boundary *boundary, const hsp_measure_request *request,
                                  hsp_measure_outputs *outputs) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return status;
  hsp_measure_request asked;
  hsp_measure_outputs out;
  Executor executor(arithmetic);
  if (const int32_t status = versions_first(read_request(request, asked, executor), read_struct(outputs, {}, out));
      status != HSP_OK)
    return outputs != nullptr && out.reserved != 0 ? HSP_E_VERSION : status;
  if (out.reserved != 0) return HSP_E_VERSION;
  if (!boundary->has_areas() || (boundary->of_some && out.volume_term != nullptr)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const bool wanted = out.area != nullptr || out.volume_term != nullptr;
  if (!fits(wanted, out.capacity, grid.balls().n, &outputs->needed)) return HSP_E_CAPACITY;
  const hsp::Boundary &structure = boundary->structure();
  hsp::BallMeasure total;
  if (!executor.is_parallel() && !executor.may_stop()) {
    total = hsp::measure_into(grid, structure, asked.selected, out.area, out.volume_term);
  } else if (!hsp::measure_in_parts(executor, grid, structure, asked.selected, out.area, out.volume_term, total)) {
    return executor.status();
  }
  if (out.totals != nullptr) *out.totals = {total.area, boundary->of_some ? not_known : total.volume, {0, 0}};
  return HSP_OK;
}

int32_t hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume_term, uint32_t capacity,
                                   uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(boundary); status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const bool wanted = area != nullptr || volume_term != nullptr;
  if (!fits(wanted, capacity, structure.face_count(), needed)) return HSP_E_CAPACITY;
  if (!wanted) return HSP_OK;
  const hsp::BallSet &balls = boundary->balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    hsp::measure_faces(balls, structure, i, [&](uint32_t face, const hsp::BallMeasure &measure) {
      if (area != nullptr) area[face] = balls.lattice.area(measure.area);
      if (volume_term != nullptr) volume_term[face] = balls.lattice.volume(measure.volume);
    });
  }
  return HSP_OK;
}
