/* How large a picture is, and what part of what is seen it shows. */
#pragma once

#include "draw/drawing.h"
#include "draw/front_grid.h"
#include "hardsphere.h"

/* The page in px, which files are written in, and where it has what. */
struct picture_frame {
  double width, height;
  double scale, x, y;   /* of a fixed frame: the point (u, v) of the view is at (x + scale u, y - scale v), y down */
  double letter;        /* the size of letters */
  double column, strip; /* of the room for annotations: how wide it is on each side, how high below; 0: none */
};

/* Sets both sides of a picture of which one or both are given, with its margin and scale. All numbers that follow in px
 * are whole: a last row of which a part is covered is a pale line. A picture that is cropped or annotated becomes one
 * with a fixed frame, with room for annotations unless the user has fixed it. */
void picture_frame_set(const struct drawing *drawing, const hsp_view_info *view, hsp_picture_options *options,
                       struct picture_frame *frame);

/* From coordinates of the molecule to those of the page. */
struct page_axes picture_frame_axes(const struct picture_frame *frame, const hsp_view_info *view);
