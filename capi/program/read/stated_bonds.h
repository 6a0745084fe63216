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
  bool *named; /* [atoms] whether an atom is in one of them */
};

/* Find the atoms of all stated bonds; those that name an atom that is not there, or several, or one atom twice, are
 * left out. To be freed on true and on false, which means that memory is short. */
bool stated_bonds_find(const struct molecule *molecule, struct stated_bonds *bonds);

void stated_bonds_free(struct stated_bonds *bonds);
