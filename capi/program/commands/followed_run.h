/* A trajectory whose cavities are followed. */
#pragma once

#include "commands/command_frames.h"
#include "commands/followed.h"
#include "commands/request.h"

/* The `of` of the work on frames: a run whose cavities are followed. */
struct followed_run {
  const struct request *request;
  struct followed followed;
};

/* All frames, and the picture of volumes that the request asks for; `what` is a word for a cavity. */
bool follow_run(const struct request *request, const struct molecule *molecule, struct frame_work work,
                const char *what, double *largest_rounding, struct failure *failure);
