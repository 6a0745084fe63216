/* hardsphere clash: a molecule against another one that is turned and moved. */
#ifndef HARDSPHERE_TOOL_COMMAND_CLASH_H
#define HARDSPHERE_TOOL_COMMAND_CLASH_H

#include <stdbool.h>

#include "app/arguments.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* One of the two, as it was asked for. */
struct clashing {
  const struct request *request;
  const struct molecule *molecule;
};

/* Write which balls meet, or say in failure why that cannot be known. */
bool command_clash(const struct clashing *fixed, const struct clashing *moving, struct text_buffer *out,
                   struct failure *failure);

#endif
