/* A command on the frames of a trajectory, one after the other. */
#pragma once

#include <stdbool.h>

#include "commands/commands.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* The work on a frame: a command prints it, or numbers are found that are taken in the order of frames. */
struct frame_work {
  command_function *command; /* NULL: there are numbers */
  size_t count;              /* of the numbers */
  bool (*evaluate)(const void *of, const struct molecule *molecule, struct geometry *geometry, double *numbers,
                   struct failure *failure);     /* by several threads at a time */
  void (*take)(void *of, const double *numbers); /* by one at a time */
  void *of;
};

/* Put each frame that the request asks for into the molecule, which is prepared, and print what the command writes for
 * it, or take its numbers, as soon as that is done with those before it. Memory is that of a few frames for each
 * thread, one without any. A failure stops all; what was printed stays. *largest_rounding becomes that of all frames,
 * as hsp_model_info has it. */
bool command_frames(const struct request *request, const struct molecule *molecule, const struct frame_work *work,
                    double *largest_rounding, struct failure *failure);
