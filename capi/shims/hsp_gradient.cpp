#include "gradient_arrays.hpp"
#include "hsp_boundary.hpp"
#include "measure/tangency.hpp"
#include "measure/totals.hpp"

using hsp::capi::check_handle;
using hsp::capi::check_results;
using hsp::capi::check_weights;
using hsp::capi::first_failure;
using hsp::capi::GradientArrays;
using hsp::capi::is_tangency;
using hsp::capi::put_vector;
using hsp::capi::to_touching_balls;

int32_t hsp_gradient_request_init(hsp_gradient_request *request, uint32_t struct_size) {
  return hsp::capi::write_struct(hsp_gradient_request{}, request, struct_size);
}

int32_t hsp_boundary_get_gradient(const hsp_boundary *boundary, const hsp_gradient_request *request,
                                  hsp_gradient_outputs *outputs) {
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return status;
  hsp::capi::GradientRequest asked;
  hsp_gradient_outputs out;
  if (const int32_t status = first_failure(asked.read(request), hsp::capi::read_struct(outputs, {}, out));
      status != HSP_OK)
    return status;
  if (!boundary->has_areas() || (boundary->of_some && asked.given.pressure != 0.0)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const GradientArrays arrays{out.d_centre, out.d_radius, out.flags};
  if (const int32_t status = asked.check(grid.balls().n, arrays.any(), *outputs); status != HSP_OK) return status;

  const hsp::Boundary &structure = boundary->structure();
  const hsp::EnergyTerms terms = asked.terms();
  const auto put = [&](uint32_t i, const hsp::EnergyGradient &gradient) { arrays.put(i, gradient); };
  hsp::Energy found;
  if (!asked.executor.is_parallel()) {
    found = hsp::differentiate_energy(grid, structure, terms, put);
  } else if (!hsp::differentiate_in_parts(asked.executor, grid, structure, terms, found, put)) {
    return HSP_E_EXECUTOR;
  }
  if (out.flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_GRADIENT_ONE_SIDED, out.flags);
  if (boundary->of_some) {
    found.volume = 0.0;
    for (uint32_t i = 0; out.flags != nullptr && i < grid.balls().n; ++i) {
      if (structure.is_left_out(i)) out.flags[grid.balls().caller[i]] = 0;
    }
  }
  if (out.energy != nullptr) *out.energy = hsp::capi::to_c(found);
  return HSP_OK;
}

int32_t hsp_boundary_gradient(const hsp_boundary *boundary, const double *sigma, double tension, double pressure,
                              uint32_t tangency, hsp_energy *energy, double *d_centre, double *d_radius,
                              uint32_t *flags, uint32_t capacity, uint32_t *needed, uint32_t *first_bad) {
  if (const int32_t status = check_results(boundary, !is_tangency(tangency)); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  const bool wanted = d_centre != nullptr || d_radius != nullptr || flags != nullptr;
  if (!hsp::capi::fits(wanted, capacity, n, needed)) return HSP_E_CAPACITY;
  if (const int32_t status = check_weights(sigma, {0, n}, first_bad); status != HSP_OK) return status;
  if (!hsp::is_finite(tension) || !hsp::is_finite(pressure)) return HSP_E_NOT_FINITE;

  const hsp::Boundary &structure = boundary->structure();
  const hsp::EnergyTerms terms{{sigma, to_touching_balls(tangency)}, tension, pressure};
  const GradientArrays arrays{d_centre, d_radius, flags};
  const hsp::Energy found = hsp::differentiate_energy(
      grid, structure, terms, [&](uint32_t i, const hsp::EnergyGradient &gradient) { arrays.put(i, gradient); });
  if (flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_GRADIENT_ONE_SIDED, flags);
  if (energy != nullptr) *energy = hsp::capi::to_c(found);
  return HSP_OK;
}

int32_t hsp_boundary_derivatives(const hsp_boundary *boundary, const double *sigma, uint32_t tangency,
                                 double *area_centre, double *area_radius, double *volume_centre, double *volume_radius,
                                 uint32_t *flags, uint32_t capacity, uint32_t *needed, uint32_t *first_bad) {
  if (const int32_t status = check_results(boundary, !is_tangency(tangency)); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  const bool wanted = area_centre != nullptr || area_radius != nullptr || volume_centre != nullptr ||
                      volume_radius != nullptr || flags != nullptr;
  if (!hsp::capi::fits(wanted, capacity, n, needed)) return HSP_E_CAPACITY;
  if (const int32_t status = check_weights(sigma, {0, n}, first_bad); status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::AreaWeights weights{sigma, to_touching_balls(tangency)};
  hsp::differentiate_measures(grid, structure, weights, [&](uint32_t i, const hsp::MeasureGradient &gradient) {
    put_vector(gradient.area_centre, area_centre, i);
    put_vector(gradient.volume_centre, volume_centre, i);
    if (area_radius != nullptr) area_radius[i] = gradient.area_radius;
    if (volume_radius != nullptr) volume_radius[i] = gradient.volume_radius;
    if (flags != nullptr) flags[i] = gradient.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
  });
  if (flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_GRADIENT_ONE_SIDED, flags);
  return HSP_OK;
}

int32_t hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
                                  hsp_area_derivative *out, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_results(boundary, (out == nullptr && capacity > 0) || !is_tangency(tangency));
      status != HSP_OK)
    return status;
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
