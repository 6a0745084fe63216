#include "conversion.hpp"
#include "residue_radii.hpp"

namespace {

bool is_set(uint32_t set) {
  return set == HSP_RADII_PROTOR || set == HSP_RADII_NACCESS;
}

}  // namespace

int32_t hsp_residue_radius(uint32_t set, const char *residue, const char *atom, double *radius) {
  if (!is_set(set) || residue == nullptr || atom == nullptr || radius == nullptr) return HSP_E_ARGUMENT;
  return hsp::find_residue_radius(static_cast<hsp::ResidueSet>(set), residue, atom, *radius) ? HSP_OK : HSP_E_ID;
}

int32_t hsp_residue_get_atoms(uint32_t set, hsp_residue_atom *out, uint32_t capacity, uint32_t *needed) {
  if (!is_set(set) || (out == nullptr && capacity > 0)) return HSP_E_ARGUMENT;
  const auto own = static_cast<hsp::ResidueSet>(set);
  const int32_t status = hsp::capi::check_output(capacity, hsp::list_residue_radii(own, nullptr), needed);
  if (status == HSP_OK) hsp::list_residue_radii(own, out);
  return status;
}
