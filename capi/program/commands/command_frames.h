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
 * it before the next one is read. Memory is that of one frame. A failure stops all; what was printed stays. */
bool command_frames(const struct request *request, struct molecule *molecule, struct geometry *geometry,
                    command_function *command, struct failure *failure);

#endif
