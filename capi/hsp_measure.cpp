#include "conversion.hpp"
#include "core/summation.hpp"
#include "measure/areas.hpp"
#include "measure/input_order.hpp"

int32_t hsp_boundary_measure(const hsp_boundary *boundary, hsp_totals *totals, double *area, double *volume,
                             uint32_t capacity) {
  return hsp_boundary_measure_selected(boundary, nullptr, totals, area, volume, capacity);
}

int32_t hsp_boundary_measure_selected(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals,
                                      double *area, double *volume, uint32_t capacity) {
  if (boundary == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*boundary)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const hsp::BallSet &balls = grid.balls();
  if ((area != nullptr || volume != nullptr) && capacity < balls.n) return HSP_E_CAPACITY;
  const hsp::Boundary &structure = boundary->builder.boundary();
  hsp::TreeSum area_sum;
  hsp::TreeSum volume_sum;
  hsp::visit_in_input_order(grid, structure, [&](uint32_t i, uint32_t place) {
    hsp::BallMeasure ball;
    if (selected == nullptr || selected[i] != 0) {
      ball = hsp::measure_ball(balls, structure, place);
    }
    area_sum.add(ball.area);
    volume_sum.add(ball.volume);
    if (area != nullptr) area[i] = balls.lattice.area(ball.area);
    if (volume != nullptr) volume[i] = balls.lattice.volume(ball.volume);
  });
  if (totals != nullptr) {
    totals->area = balls.lattice.area(area_sum.total());
    totals->volume = balls.lattice.volume(volume_sum.total());
  }
  return HSP_OK;
}

int32_t hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume, uint32_t capacity) {
  if (boundary == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*boundary)) return HSP_E_STATE;
  const hsp::Boundary &structure = boundary->builder.boundary();
  if ((area != nullptr || volume != nullptr) && capacity < structure.face_count()) return HSP_E_CAPACITY;
  if (area == nullptr && volume == nullptr) return HSP_OK;
  const hsp::BallSet &balls = boundary->model->grid.balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    hsp::measure_faces(balls, structure, i, [&](uint32_t face, const hsp::BallMeasure &measure) {
      if (area != nullptr) area[face] = balls.lattice.area(measure.area);
      if (volume != nullptr) volume[face] = balls.lattice.volume(measure.volume);
    });
  }
  return HSP_OK;
}
