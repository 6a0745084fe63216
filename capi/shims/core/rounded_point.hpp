// A point of the caller on the lattice.
#pragma once

#include "conversion.hpp"
#include "exact/lattice.hpp"

namespace hsp::capi {

// HSP_E_NOT_FINITE, or HSP_E_RANGE beyond the lattice.
inline int32_t round_point(const exact::Lattice &lattice, const double *xyz, exact::Vector &point) {
  if (lattice.round(xyz, point)) return HSP_OK;
  return is_finite(xyz[0]) && is_finite(xyz[1]) && is_finite(xyz[2]) ? HSP_E_RANGE : HSP_E_NOT_FINITE;
}

}  // namespace hsp::capi
