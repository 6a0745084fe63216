/* The direction from which most is seen of what is highlighted. */
#pragma once

#include "commands/viewing.h"
#include "draw/front_grid.h"
#include "read/failure.h"
#include "read/selection.h"

/* Of the directions with whole numbers up to 3 along the principal axes, the one with the largest sum of the square
 * roots of what is seen of each selected ball and the halves of its sticks: so much of one does not make up for little
 * of another. Sets `view`, and `up`, unless that is given, so that the molecule is widest across. */
bool highlight_view_find(const struct shown_bodies *bodies, const struct selection *selected, struct viewing *viewing,
                         struct failure *failure);
