// The conversion of curvatures and morphometric energies at the C interface, for unions in free space and in boxes.
#pragma once

#include "curvature/morphometry.hpp"
#include "gradient_arrays.hpp"

namespace hsp::capi {

static_assert(one_sided_flag == HSP_CURVATURE_ONE_SIDED);

// The caller's arrays for curvatures; each may be null.
struct CurvatureArrays {
  hsp_curvatures *totals;
  double *mean;
  int32_t *gauss_thirds;

  bool any() const { return mean != nullptr || gauss_thirds != nullptr; }
  // lattice: the input's.
  int32_t put(const CubeGrid &grid, const Boundary &boundary, const exact::Lattice &lattice,
              const hsp::Executor &executor = hsp::Executor()) const {
    const auto put_one = [this](uint32_t i, const BallCurvature &curvature) {
      if (mean != nullptr) mean[i] = curvature.mean;
      if (gauss_thirds != nullptr) gauss_thirds[i] = curvature.gauss;
    };
    const CurvatureTotals found = sum_curvatures(grid, boundary, lattice, put_one, executor);
    if (executor.is_stopped()) return HSP_E_STOPPED;
    if (totals != nullptr) *totals = {found.mean, found.gauss};
    return HSP_OK;
  }
};

// The request for a morphometric energy.
struct MorphometryRequest {
  explicit MorphometryRequest(LibraryArithmetic &arithmetic) : executor(arithmetic) {}

  hsp_morphometry_request given{};
  Executor executor;

  int32_t read(const hsp_morphometry_request *request) { return read_request(request, given, executor); }
  template <class Outputs>
  int32_t check(uint32_t n, bool wanted, Outputs &outputs) const {
    const bool are_finite =
        is_finite(given.pressure) && is_finite(given.tension) && is_finite(given.bending) && is_finite(given.gaussian);
    return check_outputs(n, given.sigma, are_finite, wanted, outputs);
  }
  MorphometricFactors factors() const { return {given.pressure, given.tension, given.bending, given.gaussian}; }
};

inline hsp_morphometric_energy to_c(const MorphometricEnergy &energy) {
  return {energy.value, energy.volume, energy.area, energy.mean, energy.gauss, energy.by_probe};
}

}  // namespace hsp::capi
