// A point of the caller on the lattice.
#pragma once

#include "conversion.hpp"
#include "exact/lattice.hpp"

namespace hsp::capi {

// The status for a point that is not on the lattice.
inline int32_t why_off_lattice(const double *xyz) {
  return is_finite(xyz[0]) && is_finite(xyz[1]) && is_finite(xyz[2]) ? HSP_E_RANGE : HSP_E_NOT_FINITE;
}

// Rounds a point. HSP_E_NOT_FINITE, or HSP_E_RANGE beyond the lattice.
inline int32_t round_point(const exact::Lattice &lattice, const double *xyz, exact::Vector &point) {
  return lattice.round(xyz, point) ? HSP_OK : why_off_lattice(xyz);
}

}  // namespace hsp::capi
