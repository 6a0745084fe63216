/* The names of what a picture shows, over it. */
#pragma once

#include "draw/annotation.h"
#include "draw/pen.h"

/* A label stands within what it names if it has room there, else as label_places.h says, on a seam of that colour.
 * Of more than have room, those stay of which most is seen; *left_out becomes how many do not. False: memory is short.
 */
bool labels_write(const struct annotation *annotation, const struct pen *pen, uint32_t colour, uint32_t seam,
                  uint32_t *left_out, struct failure *failure);
