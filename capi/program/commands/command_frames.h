/* A command for the frames of a trajectory, one after the other. */
#pragma once

#include <stdbool.h>

#include "commands/commands.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* The work on a frame: either a command prints its results, or functions find something in it and take these findings
 * in the order of frames. */
struct frame_work {
  command_function *command; /* NULL: `find` and `take` do the work */
  size_t bytes;              /* size of the findings of a frame, which are zeros at first */
  bool (*find)(const void *of, const struct molecule *molecule, struct geometry *geometry, void *findings,
               struct failure *failure); /* by several threads at a time */
  bool (*take)(void *of, const struct molecule *molecule, void *findings, struct text_buffer *out,
               struct failure *failure); /* by one at a time; may write */
  void (*clear)(void *findings);         /* must also accept zeros; NULL: there is nothing to do */
  void *of;
};

/* Put each frame that the request asks for into the molecule, which is prepared. Then print what the command writes for
 * it, or take its findings, as soon as that is done for all frames before it. Each thread has a few frames in memory at
 * a time, a single thread one. A failure stops all; what was printed stays. *largest_rounding becomes the largest of
 * all frames, as in hsp_model_info. */
bool command_frames(const struct request *request, const struct molecule *molecule, const struct frame_work *work,
                    double *largest_rounding, struct failure *failure);
