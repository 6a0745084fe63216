/* The list of all sets of radii, for a person to read. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/text_buffer.h"

/* Every set with its source: radii by element side by side, then those by residue and atom. */
bool radii_list_print(struct text_buffer *out, struct failure *failure);
