#include "curvature_rows.hpp"
#include "hsp_boundary.hpp"
#include "measure/tangency.hpp"

using hsp::capi::check_results;

int32_t hsp_boundary_curvature(const hsp_boundary *boundary, hsp_curvatures *totals, double *mean,
                               int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_results(boundary); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const hsp::capi::CurvatureArrays arrays{totals, mean, gauss_thirds};
  if (!hsp::capi::fits(arrays.any(), capacity, grid.balls().n, needed)) return HSP_E_CAPACITY;
  arrays.put(grid, boundary->structure(), grid.balls().lattice);
  return HSP_OK;
}

int32_t hsp_boundary_morphometry(const hsp_boundary *boundary, const double *sigma, const hsp_morphometry *factors,
                                 hsp_morphometric_energy *energy, double *d_centre, double *d_radius, uint32_t *flags,
                                 uint32_t capacity, uint32_t *needed, uint32_t *first_bad) {
  if (const int32_t status = check_results(boundary, factors == nullptr); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  const hsp::capi::GradientArrays arrays{d_centre, d_radius, flags};
  if (!hsp::capi::fits(arrays.any(), capacity, n, needed)) return HSP_E_CAPACITY;
  if (const int32_t status = hsp::capi::check_weights(sigma, {0, n}, first_bad); status != HSP_OK) return status;
  if (!hsp::capi::are_finite(*factors)) return HSP_E_NOT_FINITE;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::AreaWeights weights{sigma, hsp::TouchingBalls::meet};
  const hsp::MorphometricEnergy found =
      hsp::differentiate_morphometry(grid, structure, weights, hsp::capi::to_factors(*factors),
                                     [&](uint32_t i, const hsp::EnergyGradient &gradient) { arrays.put(i, gradient); });
  if (flags != nullptr) hsp::flag_free_inner_contacts(grid, structure, HSP_CURVATURE_ONE_SIDED, flags);
  if (energy != nullptr) *energy = hsp::capi::to_c(found);
  return HSP_OK;
}
