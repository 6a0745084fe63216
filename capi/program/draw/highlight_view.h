/* The direction from which most of the highlighted balls is seen. */
#pragma once

#include "commands/viewing.h"
#include "draw/front_grid.h"
#include "read/failure.h"
#include "read/selection.h"

/* Set `view` to the best of the directions with whole numbers up to 3 along the principal axes: the one with the
 * largest sum over the selected balls of the square root of the visible area, with the halves of their sticks. (Without
 * roots a large area of one ball would make up for small ones of others.) Sets `up`, too, unless it is given, so that
 * the molecule is widest across. */
bool highlight_view_find(const struct shown_bodies *bodies, const struct selection *selected, struct viewing *viewing,
                         struct failure *failure);
