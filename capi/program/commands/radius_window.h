/* The mean of a weighted area over a window of radii, R + s sigma with -w <= s <= w. As the area is the derivative of
 * the volume along the radii, that is W = (V(R + w sigma) - V(R - w sigma)) / 2w: smooth where balls touch. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

struct radius_window {
  double probe;
  double width;        /* w, above 0 */
  const double *sigma; /* [atoms]; NULL: all ones */
};

/* Takes the boundary of one of the two sets of balls, whose volume counts `factor` times. */
typedef bool take_side(void *of, const struct geometry *side, double factor, struct failure *failure);

/* Compute both sets, one after the other, on one lattice, with the threads of `whole`, which gets the largest rounding
 * of both. A radius below 0 becomes 0. */
bool radius_window_for_each_side(const struct radius_window *window, const struct molecule *molecule,
                                 struct geometry *whole, take_side *take, void *of, struct failure *failure);
