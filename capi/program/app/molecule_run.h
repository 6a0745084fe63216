/* A command for one molecule that was read. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "app/notes.h"
#include "commands/request.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* The data of the file that are kept beside the atoms: molecule_keeping. */
unsigned molecule_keeping(const struct request *request);

/* Select the atoms of the molecule that the request names, and give them radii. */
bool molecule_prepare(const struct request *request, struct molecule *molecule, struct notes *notes,
                      struct failure *failure);

/* Do with the molecule what the request asks for, by that many threads. Its balls are dropped then, unless the request
 * still needs them or the molecule is one of many. */
bool molecule_run(const struct request *request, uint32_t threads, struct molecule *molecule, struct geometry *geometry,
                  struct notes *notes, struct text_buffer *out, struct failure *failure);
