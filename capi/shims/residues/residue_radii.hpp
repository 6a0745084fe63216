// Radii by the names of residues and atoms, published ones. Chemistry: geometry knows nothing of it.
#pragma once

#include <cstdint>

#include "core/span.hpp"
#include "hardsphere.h"

namespace hsp {

enum class ResidueSet : uint32_t { protor = HSP_RADII_PROTOR, naccess = HSP_RADII_NACCESS };

// False: the set has no such atom.
bool find_residue_radius(ResidueSet set, const char *residue, const char *atom, double &radius);

// All of a set, line by line of the publication; `out` may be null. How many there are comes back.
uint32_t list_residue_radii(ResidueSet set, hsp_residue_atom *out);

}  // namespace hsp
