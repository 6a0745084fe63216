/* .xtc, GROMACS's compressed trajectories: frames of coordinates as whole multiples of a length, in nanometres. */
#pragma once

#include "read/byte_reader.h"
#include "read/line_reader.h"
#include "read/molecule.h"

/* The data from which a frame is unpacked. Zeros at first. */
struct xtc {
  unsigned char *packed;
  size_t capacity;
};

void xtc_free(struct xtc *xtc);
