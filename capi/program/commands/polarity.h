/* Whether atoms are polar: nitrogen and oxygen are, carbon, sulfur and selenium are apolar, all others are neither. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/molecule.h"

/* Set the flags of each atom. A hydrogen has those of the atom to which it is bound, by the bonds that the file states
 * or by distance; if there are several, of the nearest one; if there is none, it is neither. False: memory is short. */
bool polarity_find(struct molecule *molecule, struct failure *failure);
