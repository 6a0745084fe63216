#include "hsp_boundary.hpp"
#include "measure/tangency.hpp"
#include "measure/totals.hpp"

using hsp::capi::is_live;

namespace {

bool is_tangency(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP || tangency == HSP_TANGENT_DISJOINT;
}
hsp::TouchingBalls to_touching_balls(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP ? hsp::TouchingBalls::meet : hsp::TouchingBalls::apart;
}

static_assert(hsp::one_sided_flag == HSP_GRADIENT_ONE_SIDED);

}  // namespace

int32_t hsp_boundary_gradient(const hsp_boundary *boundary, const double *sigma, double tension, double pressure,
                              uint32_t tangency, hsp_energy *energy, double *centre, double *radius, uint32_t *flags,
                              uint32_t capacity) {
  if (!is_live(boundary) || !is_tangency(tangency)) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const hsp::BallSet &balls = grid.balls();
  const uint32_t n = balls.n;
  if ((centre != nullptr || radius != nullptr || flags != nullptr) && capacity < n) return HSP_E_CAPACITY;
  if (!hsp::is_finite(tension) || !hsp::is_finite(pressure)) return HSP_E_NOT_FINITE;
  for (uint32_t i = 0; sigma != nullptr && i < n; ++i) {
    if (!hsp::is_finite(sigma[i])) return HSP_E_NOT_FINITE;
  }

  const hsp::Boundary &structure = boundary->structure();
  const hsp::EnergyTerms terms{{sigma, to_touching_balls(tangency)}, tension, pressure};
  const hsp::Energy found =
      hsp::differentiate_energy(grid, structure, terms, [&](uint32_t i, const hsp::EnergyGradient &gradient) {
        for (size_t axis = 0; centre != nullptr && axis < 3; ++axis) {
          centre[3 * static_cast<size_t>(i) + axis] = gradient.centre[axis];
        }
        if (radius != nullptr) radius[i] = gradient.radius;
        if (flags != nullptr) flags[i] = gradient.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
      });
  if (flags != nullptr) {
    // The boundary holds nothing of balls inside others, nor of what they touch.
    hsp::visit_free_inner_contacts(grid, structure, [&](uint32_t inner, uint32_t outer) {
      flags[balls.caller[inner]] |= HSP_GRADIENT_ONE_SIDED;
      flags[balls.caller[outer]] |= HSP_GRADIENT_ONE_SIDED;
    });
  }
  if (energy != nullptr) *energy = {found.value, found.area, found.volume, found.by_probe};
  return HSP_OK;
}

int32_t hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
                                  hsp_area_derivative *out, uint32_t capacity, uint32_t *needed) {
  if (!is_live(boundary) || needed == nullptr || (out == nullptr && capacity > 0) || !is_tangency(tangency)) {
    return HSP_E_ARGUMENT;
  }
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const hsp::BallSet &balls = grid.balls();
  if (ball >= balls.n) return HSP_E_ID;
  const hsp::Boundary &structure = boundary->structure();
  const uint32_t place = grid.grid_index(ball);
  const uint32_t length = hsp::area_row_length(structure, place);
  if (const int32_t status = hsp::capi::check_output(out, capacity, length, needed); status != HSP_OK) return status;
  hsp::gather_area_row(balls, structure, place, to_touching_balls(tangency),
                       hsp::Span<hsp_area_derivative>(out, length));
  return HSP_OK;
}
