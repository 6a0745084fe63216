/* The text over a picture: labels with lines to what they name, a scale bar, and what colours stand for. */
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
  const struct ball_palette *palette; /* what colours stand for, before occlusion: */
  const uint32_t *colour;             /* [atoms] */
  const uint32_t *darkened;           /* [atoms], by occlusion */
  const struct selection *selected;   /* of these atoms */
  const double *seen;                 /* [atoms], px^2 of each, by seen_areas.h; NULL: no legend asks for it */
};

/* Append it to `out`, in the language of the picture. *left_out becomes how many labels have no room. False: memory is
 * short. */
bool annotation_write(const struct annotation *annotation, struct text_buffer *out, uint32_t *left_out,
                      struct failure *failure);
