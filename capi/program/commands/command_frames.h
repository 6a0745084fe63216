/* A command on the frames of a trajectory, one after the other. */
#ifndef HARDSPHERE_TOOL_COMMAND_FRAMES_H
#define HARDSPHERE_TOOL_COMMAND_FRAMES_H

#include <stdbool.h>

#include "commands/commands.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* Put each frame that the request asks for into the molecule, which is prepared, and print what the command writes for
 * it as soon as those before it are printed. Memory is that of a few frames for each thread, one without any. A failure
 * stops all; what was printed stays. */
bool command_frames(const struct request *request, const struct molecule *molecule, command_function *command,
                    struct failure *failure);

#endif
