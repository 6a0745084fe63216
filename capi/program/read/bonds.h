/* Which atoms are bonded: those that the file says, and those that are about as close as covalent radii say. */
#pragma once

#include "read/geometry.h"
#include "read/molecule.h"
#include "read/stated_bonds.h"

/* How much longer than the sum of the covalent radii of its atoms a bond may be, in angstrom. */
#define BOND_TOLERANCE 0.4

/* Between the centres of two atoms. */
double atoms_squared_distance(const struct molecule *molecule, uint32_t i, uint32_t j);

/* The bonds of a molecule, by their smaller atoms; *bonds is to be freed on true.
 *
 * Records of bonds tell which of the atoms that they name are bonded to each other, and may tell how. Files of the
 * Protein Data Bank have them for ligands and for links of residues, but not within residues: for all other pairs
 * distances decide. A record does not count that names an atom that is not there, or several, or one atom twice.
 *
 * By distances two atoms are not bonded if a third one that is close enough to both lies between them, where the
 * angle is more than 80 degrees. An atom of no known element counts as carbon; noble gases, alkali and alkaline earth
 * metals but beryllium have no bonds. The model of the geometry becomes another one. */
bool bonds_find(const struct molecule *molecule, struct geometry *geometry, struct bond **bonds, uint32_t *count,
                struct failure *failure);
