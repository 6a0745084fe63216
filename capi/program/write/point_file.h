/* Points with radii as atoms of a file that viewers show: .pdb or .cif. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"

struct point {
  const char *atom;    /* up to three letters, as the next one */
  const char *residue; /* which list it is of */
  char chain;
  uint32_t number; /* of what it belongs to in that list: of the residue */
  double xyz[3];
  double radius; /* the temperature factor */
  bool joined;   /* to the point before */
};

/* Write them to a .cif file if the path ends so, else to a .pdb file, which has no room for 100,000 of them. In that
 * joined points have bonds; coordinates and radii that are too wide for its columns have fewer decimals. */
bool point_file_write(const struct point *points, size_t count, const char *path, struct failure *failure);
