#include "curvature_rows.hpp"
#include "hsp_periodic.hpp"
#include "periodic/periodic_morphometry.hpp"

using namespace hsp::capi;

int32_t hsp_periodic_curvature(const hsp_periodic *periodic, hsp_curvatures *totals, double *mean,
                               int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(periodic); status != HSP_OK) return status;
  const CurvatureArrays arrays{totals, mean, gauss_thirds};
  if (!fits(arrays.any(), capacity, periodic->balls(), needed)) return HSP_E_CAPACITY;
  const hsp::PeriodicUnion &structure = periodic->builder;
  // Lengths of the set are in steps.
  return arrays.put(structure.grid(), structure.boundary(), structure.images().lattice());
}

int32_t hsp_periodic_get_morphometry(const hsp_periodic *periodic, const hsp_morphometry_request *request,
                                     hsp_periodic_morphometry_outputs *outputs) {
  LibraryArithmetic arithmetic;
  MorphometryRequest asked(arithmetic);
  hsp_periodic_morphometry_outputs out;
  if (const int32_t status = read_question(periodic, request, asked, outputs, out); status != HSP_OK) return status;
  const GradientArrays arrays{out.d_centre, out.d_radius, out.flags, out.area};
  if (const int32_t status = asked.check(periodic->balls(), arrays.any(), *outputs); status != HSP_OK) return status;

  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::AreaWeights weights = hsp::weights_in_box(structure, asked.given.sigma, hsp::TouchingBalls::meet);
  const hsp::MorphometricFactors factors = asked.factors();
  hsp::MorphometricEnergy found;
  if (!hsp::differentiate_morphometry_in_box(asked.executor, structure, weights, factors, found,
                                             [&](uint32_t i, const hsp::EnergyGradient &gradient) {
                                               arrays.put(i, gradient, structure.images().lattice());
                                             }))
    return asked.executor.status();
  if (out.flags != nullptr) hsp::flag_free_inner_contacts_in_box(structure, HSP_CURVATURE_ONE_SIDED, out.flags);
  if (out.energy != nullptr) *out.energy = to_c(found);
  if (out.d_strain == nullptr && out.d_box == nullptr) return HSP_OK;
  put_box_gradient(hsp::box_gradient_of_morphometry(structure, weights, factors), out.d_strain, out.d_box);
  return HSP_OK;
}
