/* .dcd, the trajectories of CHARMM, NAMD and X-PLOR: frames of coordinates as floats, in angstrom. */
#ifndef HARDSPHERE_TOOL_READ_DCD_H
#define HARDSPHERE_TOOL_READ_DCD_H

#include "read/byte_reader.h"
#include "read/line_reader.h"
#include "read/molecule.h"

/* The data of the file before its frames. Zeros at first. */
struct dcd {
  bool highest_first; /* of the bytes of its numbers */
  bool has_cell;
  bool has_vectors; /* cells are vectors, as newer versions of CHARMM write them */
  bool has_fourth;  /* coordinate of each atom */
  int32_t first_step, interval;
  double delta;         /* time between steps, in AKMA units; 0: not known */
  uint32_t free_atoms;  /* which alone move, if some are fixed; else all */
  uint32_t *free_place; /* [free_atoms], counted from 0; NULL if none are fixed */
  uint64_t frames;      /* read or stepped over */
};

/* Read what stands before the frames. Files of another number of atoms fail. */
bool dcd_begin(struct dcd *dcd, struct byte_reader *reader, uint32_t atoms, struct failure *failure);

/* Read the next frame into xyz [atoms][3], or step over it. xyz has the frame that was read before: atoms that are
 * fixed stand in the first one alone. */
enum line_status dcd_next(struct dcd *dcd, struct byte_reader *reader, bool wanted, uint32_t atoms, double *xyz,
                          struct frame_stamp *stamp, struct failure *failure);

void dcd_free(struct dcd *dcd);

#endif
