/* A run through a trajectory in which cavities are followed. */
#pragma once

#include "commands/command_frames.h"
#include "commands/followed.h"
#include "commands/request.h"

/* The `of` of struct frame_work in such a run. */
struct followed_run {
  const struct request *request;
  struct followed followed;
};

/* Go through all frames, and draw the volumes if the request asks for it; `what` is a word for a cavity. */
bool follow_run(const struct request *request, const struct molecule *molecule, struct frame_work work,
                const char *what, double *largest_rounding, struct failure *failure);
