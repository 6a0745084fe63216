/* A molecule as small balls for its atoms and sticks for its bonds. */
#pragma once

#include "draw/drawing.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* The radii of balls, as a part of those of the atoms. */
double ball_and_stick_size(const struct drawing *drawing);

/* That of sticks. */
double ball_and_stick_radius(const struct drawing *drawing);

/* Find the bonds, which the geometry keeps, and compute balls and sticks into it; its model becomes that of the small
 * balls. colour: that of each atom; a bond between equal ones is a whole stick. False, with the balls and sticks that
 * are in each other's way named, if these cannot be drawn. */
bool ball_and_stick_compute(const struct molecule *molecule, const struct drawing *drawing, const uint32_t *colour,
                            struct geometry *geometry, struct failure *failure);
