/* A molecule as small balls for its atoms and sticks for its bonds. */
#pragma once

#include "draw/drawing.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* The radii of balls as parts of those of the atoms. */
double ball_and_stick_size(const struct drawing *drawing);

/* The radius of sticks. */
double ball_and_stick_radius(const struct drawing *drawing);

/* Find the bonds, and compute balls and sticks. The geometry keeps both, and its model becomes that of the small balls.
 * colour: of each atom; a bond between equal colours is one stick, not two halves. False, with the balls and sticks
 * named, if some intersect in a way that cannot be drawn. */
bool ball_and_stick_compute(const struct molecule *molecule, const struct drawing *drawing, const uint32_t *colour,
                            struct geometry *geometry, struct failure *failure);
