/* Bonds: those that the file states, and pairs of atoms that are about as close as the sum of their covalent radii. */
#pragma once

#include "read/geometry.h"
#include "read/molecule.h"
#include "read/stated_bonds.h"

/* How much longer than the sum of the covalent radii of its atoms a bond may be, in angstrom. */
#define BOND_TOLERANCE 0.4

/* The squared distance between the centres of two atoms. */
double atoms_squared_distance(const struct molecule *molecule, uint32_t i, uint32_t j);

/* Find the bonds of a molecule, ordered by their atoms with the smaller number; *bonds has to be freed on true.
 *
 * Records of bonds tell which of the atoms that they name are bonded to each other, and may tell the kind of bond.
 * Files of the Protein Data Bank have records for ligands and for links of residues, but not within residues: for all
 * other pairs distances decide. A record does not count if it names an atom that is not there, or several, or one
 * twice.
 *
 * By distances two atoms are not bonded if a third one that is close enough to both lies between them, with an angle of
 * more than 80 degrees. An atom of an unknown element counts as carbon; noble gases, alkali and alkaline earth metals
 * but beryllium have no bonds. The model of the geometry is replaced. */
bool bonds_find(const struct molecule *molecule, struct geometry *geometry, struct bond **bonds, uint32_t *count,
                struct failure *failure);
