#include "element_radii.hpp"
#include "element_symbols.hpp"
#include "hardsphere.h"
#include "library_arithmetic.hpp"

using namespace hsp::capi;

static_assert(static_cast<uint32_t>(hsp::RadiiSet::bondi) == HSP_RADII_BONDI &&
              static_cast<uint32_t>(hsp::RadiiSet::chem3d) == HSP_RADII_CHEM3D &&
              static_cast<uint32_t>(hsp::RadiiSet::uff) == HSP_RADII_UFF);

int32_t hsp_element_radius(uint32_t set, uint32_t atomic_number, double *radius, uint32_t *flags) {
  LibraryArithmetic arithmetic;
  if ((set > HSP_RADII_CHEM3D && set != HSP_RADII_UFF) || radius == nullptr) return HSP_E_ARGUMENT;
  if (atomic_number < 1 || atomic_number > hsp::element_count) return HSP_E_ID;
  const hsp::ElementRadius found = hsp::element_radius(static_cast<hsp::RadiiSet>(set), atomic_number);
  *radius = found.radius;
  if (flags != nullptr) *flags = found.fallback ? HSP_RADIUS_FALLBACK : 0;
  return HSP_OK;
}

int32_t hsp_element_number(const char *symbol, uint32_t *atomic_number) {
  if (symbol == nullptr || atomic_number == nullptr) return HSP_E_ARGUMENT;
  const uint32_t number = hsp::element_number(symbol);
  if (number == 0) return HSP_E_ID;
  *atomic_number = number;
  return HSP_OK;
}

const char *hsp_element_symbol(uint32_t atomic_number) {
  return hsp::element_symbol(atomic_number);
}
