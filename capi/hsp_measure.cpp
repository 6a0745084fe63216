#include "hsp_boundary.hpp"
#include "measure/totals.hpp"

using hsp::capi::is_live;

int32_t hsp_boundary_measure(const hsp_boundary *boundary, hsp_totals *totals, double *area, double *volume,
                             uint32_t capacity) {
  return hsp_boundary_measure_selected(boundary, nullptr, totals, area, volume, capacity);
}

int32_t hsp_boundary_measure_selected(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals,
                                      double *area, double *volume, uint32_t capacity) {
  if (!is_live(boundary)) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  if ((area != nullptr || volume != nullptr) && capacity < grid.balls().n) return HSP_E_CAPACITY;
  const hsp::BallMeasure total =
      hsp::measure_union(grid, boundary->structure(), selected, [&](uint32_t i, const hsp::BallMeasure &measure) {
        if (area != nullptr) area[i] = measure.area;
        if (volume != nullptr) volume[i] = measure.volume;
      });
  if (totals != nullptr) *totals = {total.area, total.volume};
  return HSP_OK;
}

int32_t hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume, uint32_t capacity) {
  if (!is_live(boundary)) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::Boundary &structure = boundary->structure();
  if ((area != nullptr || volume != nullptr) && capacity < structure.face_count()) return HSP_E_CAPACITY;
  if (area == nullptr && volume == nullptr) return HSP_OK;
  const hsp::BallSet &balls = boundary->balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    hsp::measure_faces(balls, structure, i, [&](uint32_t face, const hsp::BallMeasure &measure) {
      if (area != nullptr) area[face] = balls.lattice.area(measure.area);
      if (volume != nullptr) volume[face] = balls.lattice.volume(measure.volume);
    });
  }
  return HSP_OK;
}
