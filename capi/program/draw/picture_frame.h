/* The size of a picture, and the part of the view that it shows. */
#pragma once

#include "draw/drawing.h"
#include "draw/front_grid.h"
#include "hardsphere.h"

/* The page, and places on it. Lengths are px, the unit of the files. */
struct picture_frame {
  double width, height;
  double scale, x, y;   /* in a fixed frame the point (u, v) of the view is at (x + scale u, y - scale v), y down */
  double letter;        /* the size of letters */
  double column, strip; /* room for annotations: its width on each side, its height below; 0: none */
};

/* Set width and height of a picture, one or both of which are given, with its margin and scale. Results in px are whole
 * numbers: a last row that is only partly covered would be a pale line. A picture that is cropped or annotated gets a
 * fixed frame, with room for annotations unless the user has fixed the frame. */
void picture_frame_set(const struct drawing *drawing, const hsp_view_info *view, hsp_picture_options *options,
                       struct picture_frame *frame);

/* The axes that take coordinates of the molecule to those of the page. */
struct page_axes picture_frame_axes(const struct picture_frame *frame, const hsp_view_info *view);
