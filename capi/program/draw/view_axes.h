/* Directions of a view in the form that the library takes. */
#pragma once

#include <stdbool.h>

#include "commands/viewing.h"
#include "hardsphere.h"
#include "read/molecule.h"

/* Set the options of a view by those that a user gives, defaults included. Returns the status of the library. */
int32_t viewing_options(const struct viewing *viewing, const struct molecule *molecule, hsp_view_options *options);

/* Find the axes to the right, upwards and towards the viewer: unit vectors. Returns the status of the library. */
int32_t viewing_axes(const struct viewing *viewing, const struct molecule *molecule, double axis[3][3]);
