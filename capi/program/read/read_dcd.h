/* .dcd, the trajectories of CHARMM, NAMD and X-PLOR: frames of coordinates as floats, in angstrom. */
#pragma once

#include "read/byte_reader.h"
#include "read/line_reader.h"
#include "read/molecule.h"

/* The data of the file before its frames. Zeros at first. */
struct dcd {
  bool highest_first; /* the highest byte of a number is first */
  bool has_cell;
  bool has_vectors; /* cells are vectors, as newer versions of CHARMM write them */
  bool has_fourth;  /* each atom has a fourth coordinate */
  int32_t first_step, interval;
  double delta;         /* time between steps, in AKMA units; 0: not known */
  uint32_t free_atoms;  /* atoms that move, if some are fixed; else all */
  uint32_t *free_place; /* [free_atoms], counted from 0; NULL if none are fixed */
  uint64_t frames;      /* read or stepped over */
};

void dcd_free(struct dcd *dcd);
