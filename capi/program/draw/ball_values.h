/* A number for every ball, for colours that stand for numbers. */
#pragma once

#include <stdbool.h>

#include "draw/drawing.h"
#include "read/failure.h"
#include "read/molecule.h"

/* Make the numbers that the drawing's colours stand for: the temperature factor of each atom, its charge, its free area
 * for a probe like a water molecule, or the numbers of the user's file. Free *value [atoms] on true. */
bool ball_values_make(const struct drawing *drawing, const struct molecule *molecule, double **value,
                      struct failure *failure);
