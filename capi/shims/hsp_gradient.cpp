#include "gradient_arrays.hpp"
#include "hsp_boundary.hpp"
#include "measure/tangency.hpp"
#include "measure/totals.hpp"

using hsp::capi::check_results;
using hsp::capi::GradientArrays;
using hsp::capi::is_tangency;
using hsp::capi::put_vector;
using hsp::capi::read_parts;
using hsp::capi::read_question;
using hsp::capi::to_touching_balls;

int32_t hsp_gradient_request_init(hsp_gradient_request *request, uint32_t struct_size) {
  return hsp::capi::write_struct(hsp_gradient_request{}, request, struct_size);
}

int32_t hsp_boundary_get_gradient(const hsp_boundary *boundary, const hsp_gradient_request *request,
                                  hsp_gradient_outputs *outputs) {
  hsp::capi::GradientRequest asked;
  hsp_gradient_outputs out;
  if (const int32_t status = read_parts(boundary, request, asked, outputs, out); status != HSP_OK) return status;
  if (!boundary->has_areas() || (boundary->of_some && asked.given.pressure != 0.0)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const GradientArrays arrays{out.d_centre, out.d_radius, out.flags};
  if (const int32_t status = asked.check(grid.balls().n, arrays.any(), *outputs); status != HSP_OK) return status;

  const hsp::Boundary &structure = boundary->structure();
  const hsp::EnergyTerms terms = asked.terms();
  const auto put = [&](uint32_t i, const hsp::EnergyGradient &gradient) { arrays.put(i, gradient); };
  hsp::Energy found;
  if (!hsp::differentiate_energy(asked.executor, grid, structure, terms, found, put)) return HSP_E_EXECUTOR;
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

int32_t hsp_boundary_get_derivatives(const hsp_boundary *boundary, const hsp_derivatives_request *request,
                                     hsp_derivatives_outputs *outputs) {
  hsp::capi::DerivativesRequest asked;
  hsp_derivatives_outputs out;
  if (const int32_t status = read_question(boundary, request, asked, outputs, out); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  const bool wanted = out.area_centre != nullptr || out.area_radius != nullptr || out.volume_centre != nullptr ||
                      out.volume_radius != nullptr || out.flags != nullptr;
  if (const int32_t status = hsp::capi::check_outputs(n, asked.given.sigma, wanted, *outputs); status != HSP_OK)
    return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::AreaWeights weights{asked.given.sigma, to_touching_balls(asked.given.tangency)};
  const bool each = hsp::for_each_range(asked.executor, n, [&](hsp::IdRange range) {
    hsp::differentiate_measures(grid, structure, weights, range, [&](uint32_t i, const hsp::MeasureGradient &gradient) {
      put_vector(gradient.area_centre, out.area_centre, i);
      put_vector(gradient.volume_centre, out.volume_centre, i);
      if (out.area_radius != nullptr) out.area_radius[i] = gradient.area_radius;
      if (out.volume_radius != nullptr) out.volume_radius[i] = gradient.volume_radius;
      if (out.flags != nullptr) out.flags[i] = gradient.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
    });
  });
  if (!each) return HSP_E_EXECUTOR;
  if (out.flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_GRADIENT_ONE_SIDED, out.flags);
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
