/* Published radii by residue and atom. */
#ifndef HARDSPHERE_TOOL_PROTEIN_RADII_H
#define HARDSPHERE_TOOL_PROTEIN_RADII_H

#include "read/radii_table.h"

/* J. Tsai, R. Taylor, C. Chothia and M. Gerstein, J. Mol. Biol. 290 (1999) 253: an atom's class is its element, its
 * bonds and its hydrogens. They have the 20 amino acids; nucleotides, water and some other residues are classed as
 * FreeSASA 2.1 ships it, and so is one oxygen of each carboxylate and phosphate: as a hydroxyl, O2H1. */
extern const struct radii_rule protein_radii_protor[];

/* C. Chothia, J. Mol. Biol. 105 (1976) 1, as the program NACCESS by S. Hubbard and J. Thornton uses them: 20 amino
 * acids. */
extern const struct radii_rule protein_radii_naccess[];

#endif
