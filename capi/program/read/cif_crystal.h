/* The unit cell of a block of a CIF file, and coordinates as fractions of it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/cif_row.h"
#include "read/molecule.h"

enum { CIF_MOST_ASSEMBLIES = 64 };

/* Zeros at the start of a block. */
struct cif_crystal {
  double cell[6]; /* a, b, c, alpha, beta, gamma */
  bool has[6];
  bool unknown[6];    /* it is "?" */
  bool named;         /* the space group has a name */
  enum cif_item name; /* the item that it is from */
  size_t assemblies;  /* of disordered atoms, which have alternative places; of each the first of its groups counts */
  char assembly[CIF_MOST_ASSEMBLIES][8];
  char group[CIF_MOST_ASSEMBLIES][8];
};

/* Take a value of the cell, the space group or an operator. False: it is no number, or memory is short. */
bool cif_crystal_take(struct cif_crystal *crystal, enum cif_item item, const struct cif_tokens *tokens,
                      struct symmetry *symmetry, struct failure *failure);

/* The coordinate of an atom as a fraction, and how many digits it has behind the point. Thirds and sixths rounded to
 * four decimals or more become exact. */
bool cif_crystal_fraction(struct field text, const char *name, double *value, unsigned char *digits, uint64_t line,
                          struct failure *failure);

/* Decide whether an atom is kept: of an assembly of disordered atoms the group that comes first in the file counts. */
bool cif_crystal_keeps(struct cif_crystal *crystal, const struct cif_row *row, bool *keep, struct failure *failure);

/* Put the cell into the molecule, all of whose atoms are of this block. Angles that are not given are right ones, as
 * the dictionary has it. fractional: their coordinates are fractions, and become angstrom; then a block without a cell
 * fails. */
bool cif_crystal_finish(const struct cif_crystal *crystal, bool fractional, struct molecule *molecule,
                        struct failure *failure);
