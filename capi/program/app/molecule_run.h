/* A command on one molecule that was read. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "app/notes.h"
#include "commands/request.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* Beside the atoms this is kept of its file: molecule_keeping. */
unsigned molecule_keeping(const struct request *request);

/* Choose among its atoms, and give them radii. */
bool molecule_prepare(const struct request *request, struct molecule *molecule, struct notes *notes,
                      struct failure *failure);

/* Do with it what the request asks for, by so many threads. Its balls are gone then if nothing wants them and it is not
 * one of many. */
bool molecule_run(const struct request *request, uint32_t threads, struct molecule *molecule, struct geometry *geometry,
                  struct notes *notes, struct text_buffer *out, struct failure *failure);
