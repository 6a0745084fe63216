/* A command on the frames of a trajectory, one after the other. */
#pragma once

#include <stdbool.h>

#include "commands/commands.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* The work on a frame: a command prints it, or it has findings, which are taken in the order of frames. */
struct frame_work {
  command_function *command; /* NULL: there are findings */
  size_t bytes;              /* of the findings of a frame, zeros at first */
  bool (*find)(const void *of, const struct molecule *molecule, struct geometry *geometry, void *findings,
               struct failure *failure); /* by several threads at a time */
  bool (*take)(void *of, const struct molecule *molecule, void *findings, struct text_buffer *out,
               struct failure *failure); /* by one at a time; may write */
  void (*clear)(void *findings);         /* of zeros, too; NULL: there is nothing to do */
  void *of;
};

/* Put each frame that the request asks for into the molecule, which is prepared, and print what the command writes for
 * it, or take its findings, as soon as that is done with those before it. Memory is that of a few frames for each
 * thread, one without any. A failure stops all; what was printed stays. *largest_rounding becomes that of all frames,
 * as hsp_model_info has it. */
bool command_frames(const struct request *request, const struct molecule *molecule, const struct frame_work *work,
                    double *largest_rounding, struct failure *failure);
