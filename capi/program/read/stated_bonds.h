/* The bonds that a file states, as pairs of atoms of the molecule. */
#pragma once

#include "read/molecule.h"

struct bond {
  uint32_t atom[2]; /* the smaller number first */
  enum bond_order order;
};

struct stated_bonds {
  struct bond *bond; /* [count] ascending, none twice */
  size_t count;
  bool *named; /* [atoms] whether a bond has the atom */
};

/* Find the atoms of all stated bonds. A bond is left out if one of its names fits no atom or several, or both fit the
 * same one. False: memory is short. Free the bonds on true and on false. */
bool stated_bonds_find(const struct molecule *molecule, struct stated_bonds *bonds);

void stated_bonds_free(struct stated_bonds *bonds);
