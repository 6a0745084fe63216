/* The results of the library's component sight for a molecule: views and maps. */
#pragma once

#include <stdbool.h>

#include "commands/viewing.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Cut and sort the pieces of a view, from the boundary if it was computed, else from the model alone. */
bool geometry_compute_view(struct geometry *geometry, const hsp_view_options *options, struct failure *failure);

/* Find the visible parts, from the model alone. */
bool geometry_compute_map(struct geometry *geometry, const struct viewing *viewing, const struct molecule *molecule,
                          struct failure *failure);
