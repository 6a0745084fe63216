#include "hsp_boundary.hpp"
#include "measure/totals.hpp"

using hsp::capi::check_handle;
using hsp::capi::check_results;

int32_t hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals, double *area,
                             double *volume, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_results(boundary); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const bool wanted = area != nullptr || volume != nullptr;
  if (!hsp::capi::fits(wanted, capacity, grid.balls().n, needed)) return HSP_E_CAPACITY;
  const hsp::BallMeasure total = hsp::measure_into(grid, boundary->structure(), selected, area, volume);
  if (totals != nullptr) *totals = {total.area, total.volume};
  return HSP_OK;
}

int32_t hsp_boundary_measure_range(const hsp_boundary *boundary, const uint8_t *selected, uint32_t first,
                                   uint32_t count, double *area, double *volume) {
  if (const int32_t status = check_handle(boundary, area == nullptr || volume == nullptr); status != HSP_OK)
    return status;
  const int32_t status = hsp::capi::check_range(boundary, first, count, area,
                                                [](const hsp_boundary &b) { return b.structure().ball_count(); });
  if (status != HSP_OK) return status;
  hsp::measure_balls(boundary->model->grid, boundary->structure(), selected, {first, first + count},
                     [&](uint32_t i, const hsp::BallMeasure &measure) {
                       area[i] = measure.area;
                       volume[i] = measure.volume;
                     });
  return HSP_OK;
}

int32_t hsp_boundary_measure_end(const hsp_boundary *boundary, hsp_totals *totals, double *area, double *volume) {
  if (const int32_t status = check_results(boundary, area == nullptr || volume == nullptr); status != HSP_OK)
    return status;
  const hsp::BallMeasure total = hsp::sum_and_convert(boundary->balls(), area, volume);
  if (totals != nullptr) *totals = {total.area, total.volume};
  return HSP_OK;
}

int32_t hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume, uint32_t capacity,
                                   uint32_t *needed) {
  if (const int32_t status = check_results(boundary); status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const bool wanted = area != nullptr || volume != nullptr;
  if (!hsp::capi::fits(wanted, capacity, structure.face_count(), needed)) return HSP_E_CAPACITY;
  if (!wanted) return HSP_OK;
  const hsp::BallSet &balls = boundary->balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    hsp::measure_faces(balls, structure, i, [&](uint32_t face, const hsp::BallMeasure &measure) {
      if (area != nullptr) area[face] = balls.lattice.area(measure.area);
      if (volume != nullptr) volume[face] = balls.lattice.volume(measure.volume);
    });
  }
  return HSP_OK;
}
