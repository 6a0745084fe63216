/* Directions of a view as the library has them. */
#pragma once

#include <stdbool.h>

#include "commands/viewing.h"
#include "hardsphere.h"
#include "read/molecule.h"

/* Sets the options that a user gives, defaults included, for looking at a molecule. The status of the library. */
int32_t viewing_options(const struct viewing *viewing, const struct molecule *molecule, hsp_view_options *options);

/* Axes to the right, upwards and towards the viewer: unit vectors. The status of the library. */
int32_t viewing_axes(const struct viewing *viewing, const struct molecule *molecule, double axis[3][3]);
