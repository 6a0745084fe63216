/* Points with radii, written as atoms of a file that viewers show: .pdb or .cif. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"

struct point {
  const char *atom;    /* up to three letters */
  const char *residue; /* up to three letters that name the list of the point */
  char chain;
  uint32_t number; /* the residue's number: of the thing in that list to which the point belongs */
  double xyz[3];
  double radius; /* written as the temperature factor */
  bool joined;   /* to the point before */
};

/* Write them to a .cif file if the path ends so, else to a .pdb file, which has no room for 100,000 of them. In a .pdb
 * file joined points have bonds, and coordinates and radii that are too wide for its columns have fewer decimals. */
bool point_file_write(const struct point *points, size_t count, const char *path, struct failure *failure);
