/* The text over a picture: labels with lines to the things they name, a scale bar, and a legend of colours. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/ball_colours.h"
#include "draw/drawing.h"
#include "draw/front_grid.h"
#include "draw/page_labels.h"
#include "draw/picture_frame.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

struct annotation {
  const struct drawing *drawing;
  const struct molecule *molecule;
  const hsp_picture_options *options;
  struct picture_frame frame;
  const hsp_view_info *view;
  const struct shown_bodies *bodies;
  const struct page_label *labels; /* [label_count] */
  uint32_t label_count;
  const struct ball_palette *palette; /* the meaning of colours */
  const uint32_t *colour;             /* [atoms], before occlusion */
  const uint32_t *darkened;           /* [atoms], after it */
  const struct selection *selected;   /* the atoms with labels */
  const double *seen;                 /* [atoms], px^2 seen of each (seen_areas.h); NULL: no legend needs it */
};

/* Append the text to `out`, in the language of the picture. *left_out becomes the number of labels without room. False:
 * memory is short. */
bool annotation_write(const struct annotation *annotation, struct text_buffer *out, uint32_t *left_out,
                      struct failure *failure);
