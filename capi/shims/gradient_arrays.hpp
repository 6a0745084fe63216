// How derivatives of areas and volume cross the C interface.
#pragma once

#include "conversion.hpp"
#include "measure/totals.hpp"

namespace hsp::capi {

constexpr bool is_tangency(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP || tangency == HSP_TANGENT_DISJOINT;
}
constexpr TouchingBalls to_touching_balls(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP ? TouchingBalls::meet : TouchingBalls::apart;
}

static_assert(one_sided_flag == HSP_GRADIENT_ONE_SIDED);

// Where gradients go; each may be null.
struct GradientArrays {
  double *d_centre, *d_radius;
  uint32_t *flags;

  bool any() const { return d_centre != nullptr || d_radius != nullptr || flags != nullptr; }
  void put(uint32_t i, const EnergyGradient &gradient) const {
    put_vector(gradient.centre, d_centre, i);
    if (d_radius != nullptr) d_radius[i] = gradient.radius;
    if (flags != nullptr) flags[i] = gradient.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
  }
};

inline hsp_energy to_c(const Energy &energy) {
  return {energy.value, energy.area, energy.volume, energy.by_probe};
}

}  // namespace hsp::capi
