/* Labels over a picture. */
#pragma once

#include "draw/annotation.h"
#include "draw/pen.h"

/* Write labels in a colour, with a seam of the colour `seam` around letters. A label stands within the thing it names
 * if it has room there, else as in label_places.h. If not all have room, the ones whose things are seen most are
 * written; *left_out becomes the number of others. False: memory is short. */
bool labels_write(const struct annotation *annotation, const struct pen *pen, uint32_t colour, uint32_t seam,
                  uint32_t *left_out, struct failure *failure);
