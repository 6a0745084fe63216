/* .trr, GROMACS's trajectories in full precision: frames of floats or doubles, in nanometres. */
#ifndef HARDSPHERE_TOOL_READ_TRR_H
#define HARDSPHERE_TOOL_READ_TRR_H

#include "read/byte_reader.h"
#include "read/line_reader.h"
#include "read/molecule.h"

/* Read the next frame that has coordinates into xyz [atoms][3], in angstrom, or step over it; frames of velocities or
 * forces alone are none. Frames of another number of atoms fail. */
enum line_status trr_next(struct byte_reader *reader, bool wanted, uint32_t atoms, double *xyz,
                          struct frame_stamp *stamp, struct failure *failure);

#endif
