/* Where labels stand that have no room within what they name. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "draw/front_grid.h"
#include "read/selection.h"

/* Page coordinates are px, y down. */
struct placed_label {
  const char *text;
  uint32_t atom;    /* whose ball it names */
  double at[2];     /* where that is seen best: where the line ends */
  double centre[2]; /* of the ball's disc */
  double radius;
  double seen;     /* the radius of the largest circle in what is seen of it */
  bool needs_line; /* beside the disc nobody would know what it names */

  /* The place: */
  double wide;             /* its text */
  double text_at[2];       /* the middle of its left end, its own middle or that of its right end, by the anchor */
  double anchor;           /* as in struct pen_text */
  bool has_line;           /* from `from` to `knee`, and from there to `at` */
  double from[2], knee[2]; /* the same point if it is straight */
  double box[4];           /* of its letters: left, top, right, bottom */
  double cost;             /* of the place */
};

struct label_page {
  const struct front_grid *front;
  const struct molecule *molecule;
  const struct selection *selected; /* the others may be written over, if it must be */
  double low[2], high[2];           /* of the part of the page for labels */
  double size;                      /* of letters */
  double apart;                     /* labels are at least, in sizes */
};

/* Sets the places of labels: none touches another one, its line or one of the boxes, and no two lines cross. A label
 * stands beside its disc, where nothing else is near; else at the end of a line that is level, upright or goes at 45
 * degrees, or begins upright or at 45 degrees and goes on on the level: the shortest that crosses least. Of up to 24
 * labels pairs choose anew together, where both do better so, in four rounds. *placed becomes how many have places.
 * False for want of memory. */
bool label_places_find(const struct label_page *page, const double (*boxes)[4], size_t box_count,
                       struct placed_label *label, size_t count, size_t *placed);

/* False: there is no room for it. */
bool label_is_placed(const struct placed_label *label);
