/* hardsphere/residue.h: radii by the names of residues and atoms, for proteins and nucleic acids without hydrogens.
 *
 * Guide: questions.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * In such a set a heavy atom's radius depends on its bonds and covers its hydrogens. Each set is a table of names.
 * Areas differ by some percent between sets, so name the set together with results. For atoms that a set lacks, as
 * those of ligands, ions and hydrogens, take a radius by element: hsp_element_radius. */
#ifndef HARDSPHERE_RESIDUE_H
#define HARDSPHERE_RESIDUE_H

#include "element.h"
#include "export.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** J. Tsai, R. Taylor, C. Chothia and M. Gerstein, J. Mol. Biol. 290 (1999) 253: an atom's class is its element, its
 *  bonds and its hydrogens. Published: the 20 amino acids. Nucleotides, water and some other residues have the classes
 *  of the ProtOr table that FreeSASA 2.1 ships; from there, too, one oxygen of each carboxylate and phosphate is a
 *  hydroxyl. */
#define HSP_RADII_PROTOR UINT32_C(2)

/** C. Chothia, J. Mol. Biol. 105 (1976) 1, as the program NACCESS by S. Hubbard and J. Thornton uses them: the 20 amino
 *  acids. */
#define HSP_RADII_NACCESS UINT32_C(3)

/** The radius of an atom by the name of its residue and its own, as in files of the Protein Data Bank, also by names of
 *  Amber and CHARMM: *radius in angstrom. set is HSP_RADII_PROTOR or HSP_RADII_NACCESS. Names are NUL-terminated texts
 *  in any case of their letters, with blanks before and behind where a file has them. On failure nothing is written.
 *
 *  Cost: O(1), some hundred comparisons of names.
 *  @retval HSP_E_ARGUMENT  residue, atom or radius is NULL; another set
 *  @retval HSP_E_ID        the set has no such residue, or no such atom in it */
HSP_API int32_t HSP_CALL hsp_residue_radius(uint32_t set, const char *residue, const char *atom, double *radius);

/** An atom of a set. Frozen. */
typedef struct hsp_residue_atom {
  char residue[8]; /**< its name, in upper case, NUL-terminated */
  char atom[8];    /**< likewise */
  double radius;   /**< angstrom */
} hsp_residue_atom;

/** All atoms of a set, HSP_RADII_PROTOR or HSP_RADII_NACCESS, in the order of its publication, for tables of one's own.
 *  - Property 1: hsp_residue_radius finds each of them with its radius, and no other.
 *
 *  @retval HSP_E_ARGUMENT  out is NULL with a capacity above 0; another set
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed */
HSP_API int32_t HSP_CALL hsp_residue_get_atoms(uint32_t set, hsp_residue_atom *out, uint32_t capacity,
                                               uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
