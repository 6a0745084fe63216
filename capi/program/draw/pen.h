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

/* Before and after everything else. */
void pen_begin(const struct pen *pen);
void pen_end(const struct pen *pen);

/* A line with round ends; of no length it is a dot. */
void pen_line(const struct pen *pen, const double from[2], const double to[2], double width, uint32_t colour);

void pen_rectangle(const struct pen *pen, const double corner[2], double width, double height, uint32_t colour);

/* The square of an entry in a legend whose letters have that size, in a frame, so that it is seen on a page of its own
 * colour, too. */
void pen_swatch(const struct pen *pen, const double corner[2], double letter, uint32_t colour, uint32_t frame);

/* The same in stripes of several colours, and how wide it is, in letters. */
void pen_swatch_of(const struct pen *pen, const double corner[2], double letter, const uint32_t *colour, size_t colours,
                   uint32_t frame);
double pen_swatch_width(size_t colours);

/* A text on a line at (x, y), which begins there with anchor 0, has its middle there with .5 and ends there with 1.
 * Around its letters lies a seam, so that it is read over anything, unless it has their colour. Of ASCII, and of an
 * angstrom's sign and a raised 2 (in UTF-8), it shows all characters, of others none. In PDF the font is Helvetica,
 * one of the fonts that every reader has, named as the library's files do. */
struct pen_text {
  const char *text;
  double x, y, size, anchor;
  uint32_t colour, seam;
};
void pen_write(const struct pen *pen, const struct pen_text *text);
