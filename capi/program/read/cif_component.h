/* The coordinates of a chemical component, of which a file has up to three sets, whole or not. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/cif_row.h"
#include "read/molecule.h"

enum { CIF_SETS = 3 };

/* Zeros at first. */
struct cif_component {
  double *xyz[CIF_SETS];  /* [atoms][3] */
  bool broken[CIF_SETS];  /* the set lacks a coordinate */
  size_t atoms, capacity; /* atoms of all sets */
};

/* Take the coordinates of one more atom. False: something is no number, or memory is short. */
bool cif_component_take(struct cif_component *component, const struct cif_row *row, struct failure *failure);

/* Put the first whole set into the molecule, which has as many atoms: the ideal one, that of a model, or x, y, z. The
 * molecule gets its name. False: there is none. */
bool cif_component_finish(const struct cif_component *component, struct molecule *molecule, struct failure *failure);

/* Take a bond of any component, as bonds may come before atoms, if the row is one. False when memory is short. */
bool cif_component_take_bond(const struct cif_row *row, struct molecule *molecule, struct failure *failure);

/* The end of a block: leave out bonds of other components than the molecule is. */
void cif_component_choose_bonds(struct molecule *molecule);

void cif_component_free(struct cif_component *component);
