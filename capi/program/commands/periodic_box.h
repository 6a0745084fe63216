/* The periodic box of --box: the user's, or that of the file of the molecule or of its frames; the latter with copies
 * by symmetry, or without them, for which the user writes "p1". */
#pragma once

#include <stdbool.h>

enum box_source { BOX_NONE, BOX_GIVEN, BOX_OF_FILE };

struct box_choice {
  enum box_source source;
  double vector[9];    /* of BOX_GIVEN */
  bool without_copies; /* for BOX_OF_FILE: no copies by symmetry are to fill it */
};
