/* How much is seen of each ball of a picture, and which balls are painted at all. */
#pragma once

#include <stdbool.h>

#include "draw/front_grid.h"
#include "draw/picture_frame.h"
#include "hardsphere.h"
#include "read/failure.h"

/* Which of so many balls have pieces in a view, to be freed on true: all others are hidden, and some of these. */
bool seen_areas_find_painted(const hsp_view *view, uint32_t atoms, bool **painted, struct failure *failure);

/* The area on the page, px^2, of what is seen of each ball and of its halves of sticks, as far as a grid tells that has
 * 64 cells for the square of a letter: of specks, which are lost between lines, nothing is seen. To be freed on true.
 */
bool seen_areas_find(const struct shown_bodies *bodies, const struct picture_frame *frame, const hsp_view_info *view,
                     double **area, struct failure *failure);
