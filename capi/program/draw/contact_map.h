/* A picture of who touches whom: a square for every pair of balls, residues or chains, darker the more area they have
 * in contact. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"
#include "read/residues.h"

struct contact_square {
  uint32_t first, second; /* below rows; each pair once */
  double area;            /* above 0 */
};

struct contact_map {
  const struct molecule *molecule;
  const struct atom_groups *groups; /* of grouping GROUPING_NONE: rows are balls */
  uint32_t rows;
  const struct contact_square *squares; /* [count] */
  uint32_t count;
  bool dark; /* the page */
};

/* Write it as .svg, symmetric about its diagonal, with an axis and a scale of areas. */
bool contact_map_write(const struct contact_map *map, const char *path, struct failure *failure);
