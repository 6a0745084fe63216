/* A chart of the volumes of cavities by frame. */
#pragma once

#include "commands/followed.h"

/* Write it as .svg: a line for each of the cavities with most volume over all frames, six at most, with gaps where
 * there is no such cavity. noun: the word for a cavity. */
bool volumes_write(const struct followed *followed, const struct molecule *molecule, const char *noun, const char *path,
                   struct failure *failure);
