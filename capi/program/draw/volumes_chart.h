/* The volumes of cavities by frame as a chart. */
#pragma once

#include "commands/followed.h"

/* Write it as .svg: a line for each of those that have most volume over all frames, six at most, with gaps where they
 * are not there. noun: what one is called. */
bool volumes_write(const struct followed *followed, const struct molecule *molecule, const char *noun, const char *path,
                   struct failure *failure);
