#include "curvature_rows.hpp"
#include "hsp_boundary.hpp"
#include "measure/tangency.hpp"

using namespace hsp::capi;

int32_t hsp_boundary_curvature(const hsp_boundary *boundary, hsp_curvatures *totals, double *mean,
                               int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(boundary); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const CurvatureArrays arrays{totals, mean, gauss_thirds};
  if (!fits(arrays.any(), capacity, grid.balls().n, needed)) return HSP_E_CAPACITY;
  arrays.put(grid, boundary->structure(), grid.balls().lattice);
  return HSP_OK;
}

int32_t hsp_boundary_get_morphometry(const hsp_boundary *boundary, const hsp_morphometry_request *request,
                                     hsp_morphometry_outputs *outputs) {
  LibraryArithmetic arithmetic;
  MorphometryRequest asked(arithmetic);
  hsp_morphometry_outputs out;
  if (const int32_t status = read_question(boundary, request, asked, outputs, out); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const GradientArrays arrays{out.d_centre, out.d_radius, out.flags, out.area};
  if (const int32_t status = asked.check(grid.balls().n, arrays.any(), *outputs); status != HSP_OK) return status;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::AreaWeights weights{asked.given.sigma, hsp::TouchingBalls::meet};
  hsp::MorphometricEnergy found;
  if (!hsp::differentiate_morphometry(
          asked.executor, grid, structure, weights, asked.factors(), found,
          [&](uint32_t i, const hsp::EnergyGradient &gradient) { arrays.put(i, gradient, grid.balls().lattice); }))
    return asked.executor.status();
  if (out.flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_CURVATURE_ONE_SIDED, out.flags);
  if (out.energy != nullptr) *out.energy = to_c(found);
  return HSP_OK;
}
