/* The periodic box of --box: as the user gives it, or as the file with the molecule or its frames has it. */
#ifndef HARDSPHERE_TOOL_PERIODIC_BOX_H
#define HARDSPHERE_TOOL_PERIODIC_BOX_H

#include <stdbool.h>

#include "failure.h"
#include "option_reader.h"

enum box_source { BOX_NONE, BOX_GIVEN, BOX_OF_FILE };

struct box_choice {
  enum box_source source;
  double vector[9]; /* of BOX_GIVEN */
};

/* Read what stands behind --box: three lengths, nine numbers, or the word file. */
bool box_take_option(struct box_choice *choice, struct option_reader *reader, const char *value);

#endif
