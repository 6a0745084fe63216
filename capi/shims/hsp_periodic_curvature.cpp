#include "curvature_rows.hpp"
#include "hsp_periodic.hpp"
#include "periodic/periodic_morphometry.hpp"
#include "periodic/periodic_tangency.hpp"

using hsp::capi::check_results;

int32_t hsp_periodic_curvature(const hsp_periodic *periodic, hsp_curvatures *totals, double *mean,
                               int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_results(periodic); status != HSP_OK) return status;
  const hsp::capi::CurvatureArrays arrays{totals, mean, gauss_thirds};
  if (!hsp::capi::fits(arrays.any(), capacity, periodic->balls(), needed)) return HSP_E_CAPACITY;
  const hsp::PeriodicUnion &structure = periodic->builder;
  // The set has its lengths in steps.
  arrays.put(structure.grid(), structure.boundary(), structure.images().lattice());
  return HSP_OK;
}

int32_t hsp_periodic_morphometry(const hsp_periodic *periodic, const double *sigma, const hsp_morphometry *factors,
                                 hsp_morphometric_energy *energy, double *d_centre, double *d_radius, uint32_t *flags,
                                 double *d_strain, double *d_box, uint32_t capacity, uint32_t *needed,
                                 uint32_t *first_bad) {
  if (const int32_t status = check_results(periodic, factors == nullptr); status != HSP_OK) return status;
  const hsp::capi::GradientArrays arrays{d_centre, d_radius, flags};
  const uint32_t n = periodic->balls();
  if (!hsp::capi::fits(arrays.any(), capacity, n, needed)) return HSP_E_CAPACITY;
  if (const int32_t status = hsp::capi::check_weights(sigma, {0, n}, first_bad); status != HSP_OK) return status;
  if (!hsp::capi::are_finite(*factors)) return HSP_E_NOT_FINITE;

  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::AreaWeights weights = hsp::weights_in_box(structure, sigma, hsp::TouchingBalls::meet);
  const hsp::MorphometricFactors terms = hsp::capi::to_factors(*factors);
  const hsp::MorphometricEnergy found = hsp::differentiate_morphometry_in_box(
      structure, weights, terms, [&](uint32_t i, const hsp::EnergyGradient &gradient) { arrays.put(i, gradient); });
  if (flags != nullptr) hsp::flag_free_inner_contacts_in_box(structure, HSP_CURVATURE_ONE_SIDED, flags);
  if (energy != nullptr) *energy = hsp::capi::to_c(found);
  if (d_strain == nullptr && d_box == nullptr) return HSP_OK;
  hsp::capi::put_box_gradient(hsp::differentiate_morphometry_by_box(structure, weights, terms), d_strain, d_box);
  return HSP_OK;
}
