/* hardsphere/residue.h: radii by the names of residues and atoms, for proteins and nucleic acids without hydrogens.
 *
 * Guide: questions.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * In such sets a heavy atom's radius depends on its bonds and covers its hydrogens. They are tables of names: which set
 * a study used changes its areas by some percent, so that a set is named with its results. Where a set has no such
 * atom, as of ligands, ions and hydrogens, hsp_element_radius has a radius by element. */
#ifndef HARDSPHERE_RESIDUE_H
#define HARDSPHERE_RESIDUE_H

#include "element.h"
#include "export.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** J. Tsai, R. Taylor, C. Chothia and M. Gerstein, J. Mol. Biol. 290 (1999) 253: an atom's class is its element, its
 *  bonds and its hydrogens. Published: the 20 amino acids; nucleotides, water and some other residues are classed as
 *  FreeSASA 2.1 ships it, and so is one oxygen of each carboxylate and phosphate, as a hydroxyl. */
#define HSP_RADII_PROTOR UINT32_C(2)

/** C. Chothia, J. Mol. Biol. 105 (1976) 1, as the program NACCESS by S. Hubbard and J. Thornton uses them: the 20 amino
 *  acids. */
#define HSP_RADII_NACCESS UINT32_C(3)

/** The radius of an atom by the name of its residue and its own, as in files of the Protein Data Bank, also by names of
 *  Amber and CHARMM: *radius in angstrom. Names are NUL-terminated texts in any case of their letters, with blanks
 *  before and behind where a file has them. On failure nothing is written.
 *
 *  Cost: O(1), some hundred comparisons of names.
 *  @retval HSP_E_ARGUMENT  residue, atom or radius is NULL; a set without residues
 *  @retval HSP_E_ID        the set has no such residue, or no such atom in it */
HSP_API int32_t HSP_CALL hsp_residue_radius(uint32_t set, const char *residue, const char *atom, double *radius);

/** An atom of a set. Frozen. */
typedef struct hsp_residue_atom {
  char residue[8]; /**< its name, in upper case, NUL-terminated */
  char atom[8];    /**< likewise */
  double radius;   /**< angstrom */
} hsp_residue_atom;

/** All atoms of a set, in the order of its publication, for tables of one's own.
 *  - Property 1: hsp_residue_radius finds each of them with its radius, and no other.
 *
 *  @retval HSP_E_ARGUMENT  out is NULL with a capacity above 0; a set without residues
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed */
HSP_API int32_t HSP_CALL hsp_residue_get_atoms(uint32_t set, hsp_residue_atom *out, uint32_t capacity,
                                               uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
