/* The coordinates of a chemical component. A file has up to three sets of them, complete or not. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/cif_row.h"
#include "read/molecule.h"

enum { CIF_SETS = 3 };

/* Zeros at first. */
struct cif_component {
  double *xyz[CIF_SETS];  /* [atoms][3] */
  bool broken[CIF_SETS];  /* whether the set lacks a coordinate */
  size_t atoms, capacity; /* number of atoms, the same for all sets */
};

/* Take the coordinates of one more atom. False: a value is no number, or memory is short. */
bool cif_component_take(struct cif_component *component, const struct cif_row *row, struct failure *failure);

/* Put the first complete set into the molecule, which has as many atoms; in this order: ideal coordinates, those of a
 * model, x, y, z. The molecule gets the name of the set. False: no set is complete. */
bool cif_component_finish(const struct cif_component *component, struct molecule *molecule, struct failure *failure);

/* Take a bond of any component, as bonds may come before atoms, if the row has one. False: memory is short. */
bool cif_component_take_bond(const struct cif_row *row, struct molecule *molecule, struct failure *failure);

/* At the end of a block: leave out bonds of components other than the molecule. */
void cif_component_choose_bonds(struct molecule *molecule);

void cif_component_free(struct cif_component *component);
