/* The pictures of one full turn: the same balls in the same frame, turned about the upright axis. */
#pragma once

#include <stdint.h>

#include "draw/drawing.h"
#include "read/failure.h"
#include "read/molecule.h"

/* Give the drawing a frame that holds all balls in all pictures, with its margins: scale, centre, width and height.
 * Nothing is done if the user gave a scale. Returns the status of the library. */
int32_t spinning_fix_frame(struct drawing *drawing, const struct molecule *molecule, double probe);

/* The file name of one of the pictures, counted from 0: NAME-000.svg for NAME.svg. It stays valid until the next call,
 * so that a failure can tell it. NULL: memory is short. */
const char *spinning_name(const char *out, int picture);
