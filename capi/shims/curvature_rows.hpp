// How curvatures and morphometric energies cross the C interface, of unions in free space and in boxes.
#pragma once

#include "gradient_arrays.hpp"
#include "measure/morphometry.hpp"

namespace hsp::capi {

static_assert(one_sided_flag == HSP_CURVATURE_ONE_SIDED);

// Where curvatures go; each may be null.
struct CurvatureArrays {
  hsp_curvatures *totals;
  double *mean;
  int32_t *gauss_thirds;

  bool any() const { return mean != nullptr || gauss_thirds != nullptr; }
  // lattice: the input's.
  void put(const CubeGrid &grid, const Boundary &boundary, const exact::Lattice &lattice) const {
    const CurvatureTotals found =
        sum_curvatures(grid, boundary, lattice, [this](uint32_t i, const BallCurvature &curvature) {
          if (mean != nullptr) mean[i] = curvature.mean;
          if (gauss_thirds != nullptr) gauss_thirds[i] = curvature.gauss;
        });
    if (totals != nullptr) *totals = {found.mean, found.gauss};
  }
};

inline bool are_finite(const hsp_morphometry &factors) {
  return is_finite(factors.pressure) && is_finite(factors.tension) && is_finite(factors.bending) &&
         is_finite(factors.gaussian);
}
inline MorphometricFactors to_factors(const hsp_morphometry &factors) {
  return {factors.pressure, factors.tension, factors.bending, factors.gaussian};
}
inline hsp_morphometric_energy to_c(const MorphometricEnergy &energy) {
  return {energy.value, energy.volume, energy.area, energy.mean, energy.gauss, energy.by_probe};
}

}  // namespace hsp::capi
