#include "gradient_arrays.hpp"
#include "hsp_boundary.hpp"
#include "measure/energy.hpp"
#include "measure/tangency.hpp"

using namespace hsp::capi;

namespace {

// A row of the Jacobian; the array of radii may be null.
struct ArraysOfRow {
  uint32_t *balls;
  double *d_centre, *d_radius;
  uint32_t length;
  double weight;

  uint32_t &ball(uint32_t k) const { return balls[k]; }
  void clear(uint32_t k) const {
    for (uint32_t axis = 0; axis < 3; ++axis) d_centre[3 * k + axis] = 0.0;
    if (d_radius != nullptr) d_radius[k] = 0.0;
  }
  void sort() const { hsp::sort_ascending(hsp::Span<uint32_t>(balls, length)); }
  void add(uint32_t k, const hsp::AreaDerivative &part) const {
    d_centre[3 * k] += part.centre.x;
    d_centre[3 * k + 1] += part.centre.y;
    d_centre[3 * k + 2] += part.centre.z;
    if (d_radius != nullptr) d_radius[k] += part.radius;
  }
  void weigh() const {
    for (uint32_t k = 0; k < 3 * length; ++k) d_centre[k] *= weight;
    for (uint32_t k = 0; d_radius != nullptr && k < length; ++k) d_radius[k] *= weight;
  }
};

}  // namespace

int32_t hsp_gradient_request_init(hsp_gradient_request *request, uint32_t struct_size) {
  return write_struct(hsp_gradient_request{}, request, struct_size);
}

int32_t hsp_boundary_get_gradient(const hsp_boundary *boundary, const hsp_gradient_request *request,
                                  hsp_gradient_outputs *outputs) {
  LibraryArithmetic arithmetic;
  GradientRequest asked(arithmetic);
  hsp_gradient_outputs out;
  if (const int32_t status = read_parts(boundary, request, asked, outputs, out); status != HSP_OK) return status;
  if (!boundary->has_areas() || (boundary->of_some && asked.given.pressure != 0.0)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const GradientArrays arrays{out.d_centre, out.d_radius, out.flags, out.area};
  if (const int32_t status = asked.check(grid.balls().n, arrays.any(), *outputs); status != HSP_OK) return status;

  const hsp::Boundary &structure = boundary->structure();
  const hsp::EnergyTerms terms = asked.terms();
  const auto put = [&](auto where, const hsp::EnergyGradient &gradient) {
    arrays.put(where, gradient, grid.balls().lattice);
  };
  hsp::Energy found;
  if (!hsp::differentiate_energy(asked.executor, grid, structure, terms, found, put)) return asked.executor.status();
  if (out.flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_GRADIENT_ONE_SIDED, out.flags);
  if (boundary->of_some) {
    found.volume = not_known;
    boundary->clear_flags_of_left_out(out.flags);
  }
  if (out.energy != nullptr) *out.energy = to_c(found);
  return HSP_OK;
}

int32_t hsp_boundary_get_derivatives(const hsp_boundary *boundary, const hsp_derivatives_request *request,
                                     hsp_derivatives_outputs *outputs) {
  LibraryArithmetic arithmetic;
  DerivativesRequest asked(arithmetic);
  hsp_derivatives_outputs out;
  if (const int32_t status = read_parts(boundary, request, asked, outputs, out); status != HSP_OK) return status;
  const bool of_volume = out.volume_centre != nullptr || out.volume_radius != nullptr;
  if (!boundary->has_areas() || (boundary->of_some && of_volume)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  const bool wanted = out.area_centre != nullptr || out.area_radius != nullptr || of_volume || out.flags != nullptr;
  if (const int32_t status = check_outputs(n, asked.given.sigma, true, wanted, *outputs); status != HSP_OK)
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
  if (!each) return asked.executor.status();
  if (out.flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_GRADIENT_ONE_SIDED, out.flags);
  boundary->clear_flags_of_left_out(out.flags);
  return HSP_OK;
}

int32_t hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
                                  hsp_area_derivative *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return status;
  if ((out == nullptr && capacity > 0) || !is_tangency(tangency)) return HSP_E_ARGUMENT;
  if (!boundary->has_areas()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const hsp::BallSet &balls = grid.balls();
  if (ball >= balls.n) return HSP_E_ID;
  const hsp::Boundary &structure = boundary->structure();
  const uint32_t place = grid.grid_index(ball);
  const uint32_t length = hsp::area_row_length(structure, place);
  if (const int32_t status = check_output(capacity, length, needed); status != HSP_OK) return status;
  hsp::gather_area_row(balls, structure, place, to_touching_balls(tangency),
                       hsp::Span<hsp_area_derivative>(out, length));
  return HSP_OK;
}

int32_t hsp_boundary_get_area_rows(const hsp_boundary *boundary, const hsp_derivatives_request *request,
                                   uint32_t *first, uint32_t *ball, double *d_centre, double *d_radius,
                                   uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  DerivativesRequest asked(arithmetic);
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return status;
  if (const int32_t status = asked.read(request); status != HSP_OK) return status;
  if (first == nullptr || (capacity > 0 && (ball == nullptr || d_centre == nullptr))) return HSP_E_ARGUMENT;
  if (!boundary->has_areas()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  uint32_t bad = HSP_NONE;
  if (const int32_t status = check_weights(asked.given.sigma, {0, n}, &bad); status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  hsp::find_area_row_starts(grid, structure, first);
  if (needed != nullptr) *needed = first[n];
  if (capacity < first[n]) return HSP_E_CAPACITY;
  const bool each = hsp::for_each_range(asked.executor, n, [&](hsp::IdRange range) {
    hsp::visit_in_input_order(grid, structure, range, [&](uint32_t i, uint32_t place) {
      const uint32_t length = first[i + 1] - first[i];
      if (length == 0) return;
      const double weight = asked.given.sigma == nullptr ? 1.0 : asked.given.sigma[i];
      const ArraysOfRow row{ball + first[i], d_centre + 3 * size_t{first[i]},
                            d_radius == nullptr ? nullptr : d_radius + first[i], length, weight};
      hsp::gather_area_row(grid.balls(), structure, place, to_touching_balls(asked.given.tangency), length, row);
      row.weigh();
    });
  });
  return each ? HSP_OK : asked.executor.status();
}
