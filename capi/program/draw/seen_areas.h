/* The visible area of each ball in a picture, and the balls that are painted at all. */
#pragma once

#include <stdbool.h>

#include "draw/front_grid.h"
#include "draw/picture_frame.h"
#include "hardsphere.h"
#include "read/failure.h"

/* Find which balls have pieces in a view: all others are hidden, and some of these may be. Free *painted [atoms] on
 * true. */
bool seen_areas_find_painted(const hsp_view *view, uint32_t atoms, bool **painted, struct failure *failure);

/* Find the visible area of each ball and of its halves of sticks on the page, px^2, by a grid with 64 cells in the
 * square of a letter. Specks, which are lost between lines, count as invisible. Free *area on true. */
bool seen_areas_find(const struct shown_bodies *bodies, const struct picture_frame *frame, const hsp_view_info *view,
                     double **area, struct failure *failure);
