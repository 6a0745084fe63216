/* The periodic box of --box: as the user gives it, or as the file with the molecule or its frames has it, with copies
 * by symmetry or, by the name of the space group that has none, without. */
#pragma once

#include <stdbool.h>

enum box_source { BOX_NONE, BOX_GIVEN, BOX_OF_FILE };

struct box_choice {
  enum box_source source;
  double vector[9];    /* of BOX_GIVEN */
  bool without_copies; /* of BOX_OF_FILE: no copies by symmetry are to fill it */
};
