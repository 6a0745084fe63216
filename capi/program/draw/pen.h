/* Text, lines and rectangles over a picture, as SVG, PostScript or operators of PDF. Coordinates are px from the upper
 * left corner. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "read/text_buffer.h"

struct pen {
  struct text_buffer *out;
  uint32_t language; /* HSP_FORMAT_* */
  double height;     /* of the page */
};

/* Call these before and after everything else. */
void pen_begin(const struct pen *pen);
void pen_end(const struct pen *pen);

/* A line with round ends; a line without length is a dot. */
void pen_line(const struct pen *pen, const double from[2], const double to[2], double width, uint32_t colour);

void pen_rectangle(const struct pen *pen, const double corner[2], double width, double height, uint32_t colour);

/* The square of an entry in a legend with letters of size `letter`. It has a frame, so that it is also seen on a page
 * of its own colour. */
void pen_swatch(const struct pen *pen, const double corner[2], double letter, uint32_t colour, uint32_t frame);

/* The same with stripes of several colours; and its width, in letters. */
void pen_swatch_of(const struct pen *pen, const double corner[2], double letter, const uint32_t *colour, size_t colours,
                   uint32_t frame);
double pen_swatch_width(size_t colours);

/* A text on a line at (x, y): it begins there with anchor 0, has its middle there with .5 and ends there with 1. A seam
 * around its letters makes it legible over anything, unless it has their colour. Only ASCII, the sign of an angstrom
 * and a raised 2 (in UTF-8) are shown. In PDF the font is Helvetica, one of those that every reader has, with the same
 * name as in the library's files. */
struct pen_text {
  const char *text;
  double x, y, size, anchor;
  uint32_t colour, seam;
};
void pen_write(const struct pen *pen, const struct pen_text *text);
