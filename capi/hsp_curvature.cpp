#include "hsp_boundary.hpp"
#include "measure/morphometry.hpp"
#include "measure/tangency.hpp"

using hsp::capi::is_live;

int32_t hsp_boundary_curvature(const hsp_boundary *boundary, hsp_curvatures *totals, double *mean,
                               int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  if (!is_live(boundary)) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const bool wanted = mean != nullptr || gauss_thirds != nullptr;
  if (!hsp::capi::fits(wanted, capacity, grid.balls().n, needed)) return HSP_E_CAPACITY;
  const hsp::exact::Lattice &lattice = grid.balls().lattice;
  const hsp::CurvatureTotals found =
      hsp::sum_curvatures(grid, boundary->structure(), [&](uint32_t i, const hsp::BallCurvature &curvature) {
        if (mean != nullptr) mean[i] = lattice.length(curvature.mean);
        if (gauss_thirds != nullptr) gauss_thirds[i] = curvature.gauss;
      });
  if (totals != nullptr) *totals = {found.mean, found.gauss};
  return HSP_OK;
}

int32_t hsp_boundary_morphometry(const hsp_boundary *boundary, const double *sigma, const hsp_morphometry *factors,
                                 hsp_morphometric_energy *energy, double *d_centre, double *d_radius, uint32_t *flags,
                                 uint32_t capacity, uint32_t *needed, uint32_t *first_bad) {
  if (!is_live(boundary) || factors == nullptr) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  const bool wanted = d_centre != nullptr || d_radius != nullptr || flags != nullptr;
  if (!hsp::capi::fits(wanted, capacity, n, needed)) return HSP_E_CAPACITY;
  if (const int32_t status = hsp::capi::check_weights(sigma, {0, n}, first_bad); status != HSP_OK) return status;
  if (!hsp::is_finite(factors->pressure) || !hsp::is_finite(factors->tension) || !hsp::is_finite(factors->bending) ||
      !hsp::is_finite(factors->gaussian)) {
    return HSP_E_NOT_FINITE;
  }
  const hsp::Boundary &structure = boundary->structure();
  const hsp::AreaWeights weights{sigma, hsp::TouchingBalls::meet};
  const hsp::MorphometricFactors terms{factors->pressure, factors->tension, factors->bending, factors->gaussian};
  const hsp::MorphometricEnergy found = hsp::differentiate_morphometry(
      grid, structure, weights, terms, [&](uint32_t i, const hsp::EnergyGradient &gradient) {
        hsp::capi::put_vector(gradient.centre, d_centre, i);
        if (d_radius != nullptr) d_radius[i] = gradient.radius;
        if (flags != nullptr) flags[i] = gradient.one_sided ? HSP_CURVATURE_ONE_SIDED : 0;
      });
  if (flags != nullptr) {
    // The boundary holds nothing of balls inside others, nor of what they touch.
    hsp::visit_free_inner_contacts(grid, structure, [&](uint32_t inner, uint32_t outer) {
      flags[grid.balls().caller[inner]] |= HSP_CURVATURE_ONE_SIDED;
      flags[grid.balls().caller[outer]] |= HSP_CURVATURE_ONE_SIDED;
    });
  }
  if (energy != nullptr) {
    *energy = {found.value, found.volume, found.area, found.mean, found.gauss, found.by_probe};
  }
  return HSP_OK;
}
