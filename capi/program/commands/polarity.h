/* Whether atoms are polar: nitrogen and oxygen are, carbon, sulfur and selenium are apolar, all others are neither. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/molecule.h"

/* Note it of each atom. A hydrogen is what the atom is that it is bound to, by the bonds that the file states or by
 * distance; the nearest one of several counts, and without any it is neither. False: memory is short. */
bool polarity_find(struct molecule *molecule, struct failure *failure);
