/* Places for labels that have no room within the ball they name. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "draw/front_grid.h"
#include "read/selection.h"

/* Page coordinates are px, y down. */
struct placed_label {
  const char *text;
  uint32_t atom;    /* the atom whose ball it names */
  double at[2];     /* the end of its line: the point where the ball is seen best */
  double centre[2]; /* of the ball's disc */
  double radius;
  double seen;     /* the radius of the largest circle in the visible part of the ball */
  bool needs_line; /* beside the disc it would not be clear which ball it names */

  /* The place: */
  double wide;             /* the width of its text */
  double text_at[2];       /* the middle of its left end, its own middle or that of its right end, by the anchor */
  double anchor;           /* as in struct pen_text */
  bool has_line;           /* from `from` to `knee`, and from there to `at` */
  double from[2], knee[2]; /* the same point if the line is straight */
  double box[4];           /* of its letters: left, top, right, bottom */
  double cost;             /* of the place */
};

struct label_page {
  const struct front_grid *front;
  const struct molecule *molecule;
  const struct selection *selected; /* other balls may be covered by labels if need be */
  double low[2], high[2];           /* the part of the page for labels */
  double size;                      /* of letters */
  double apart;                     /* the least distance of labels, in sizes of letters */
};

/* Find places for labels: no label touches another one, another one's line or one of the boxes, and no two lines cross.
 * A label stands beside its disc if nothing else is near. Else it is at the end of a line that is level, upright or at
 * 45 degrees, or begins upright or at 45 degrees and goes on level: of the lines that cross least, the shortest. With
 * up to 24 labels, pairs choose again together if that is better for both, in four rounds. *placed becomes the number
 * of labels with places. False: memory is short. */
bool label_places_find(const struct label_page *page, const double (*boxes)[4], size_t box_count,
                       struct placed_label *label, size_t count, size_t *placed);

/* Whether a label has a place. */
bool label_is_placed(const struct placed_label *label);
