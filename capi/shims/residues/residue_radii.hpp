// Published radii by the names of residues and atoms. This is chemistry, which lib knows nothing of.
#pragma once

#include <cstdint>

#include "core/span.hpp"
#include "hardsphere.h"

namespace hsp {

enum class ResidueSet : uint32_t { protor = HSP_RADII_PROTOR, naccess = HSP_RADII_NACCESS };

// Finds a radius. False: the set has no such atom.
bool find_residue_radius(ResidueSet set, const char *residue, const char *atom, double &radius);

// Lists all radii of a set, in the order of the publication's lines; out may be null. Returns their number.
uint32_t list_residue_radii(ResidueSet set, hsp_residue_atom *out);

}  // namespace hsp
