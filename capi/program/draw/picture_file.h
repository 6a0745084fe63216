/* A picture of a computed view or map, or of balls and sticks, in a file. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "hardsphere.h"
#include "read/failure.h"
#include "read/progress.h"

struct picture {
  hsp_view *view; /* or NULL: */
  hsp_map *map;   /* or NULL: */
  hsp_sticks *sticks;
  const uint32_t *colour; /* [balls of the model], 0xRRGGBB */
  hsp_picture_options options;
  const char *title;
  const char *description;
  const char *over; /* operators painted over the picture, in its own language, or NULL */
  double page[2];   /* if there are such: width and height, px */
};

/* Write the picture to the file `path` (output_file.h); *bytes becomes its size. False, with the file named, if it
 * cannot be written in full. */
bool picture_file_write(const struct picture *picture, const char *path, const struct progress *progress,
                        uint64_t *bytes, struct failure *failure);
