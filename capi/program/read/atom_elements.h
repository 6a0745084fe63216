/* One rule for the element of an atom, which every reader calls. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/characters.h"
#include "read/fields.h"
#include "read/molecule.h"

/* The meaning of names and symbols in the files of a kind. */
enum atom_dialect {
  ATOM_NAMES,    /* .gro, .pqr, mmCIF, names of macromolecules: CA is an alpha carbon, X an unknown atom */
  ATOM_COLUMNS,  /* .pdb: the same names in four columns, blanks included */
  ATOM_AUTODOCK, /* .pdbqt: those columns, and a type of AutoDock */
  ATOM_LABELS,   /* .cif of crystals: a symbol, and characters that distinguish the sites */
  ATOM_SYMBOLS,  /* .xyz: a symbol or an atomic number; X is a dummy by which an internal coordinate was defined */
  ATOM_QUERIES,  /* .sdf: as .xyz; A, Q, L, R.. stand for atoms that a search may find */
  ATOM_TYPES     /* .mol2: a type of SYBYL or of a force field, beside a name */
};

/* The words of a file on an atom's element. Both may be empty. The residue is that of the label. */
struct atom_evidence {
  enum atom_dialect dialect;
  struct field name;   /* as written */
  struct field stated; /* a symbol, an atomic number or a type */
};

/* Find the element of an atom of the labelled residue, or find that it is no atom. False: what the file states is no
 * element, or neither that nor a label or name beside it tells one. If there is only a name that tells none, the
 * element stays empty.
 *   1. A residue DUM has dummies, which are never atoms.
 *   2. A stated symbol counts. Deuterium and tritium are hydrogen. These symbols are no elements, but dummies and
 *      virtual sites: Du, EP, LP, M, MW; in .xyz, .sdf and .mol2 files X, too; in the last two also *, A, Q, L, R1, R#,
 *      Pol. A type of SYBYL begins with a symbol. Types in small letters or two capitals are those of GAFF and Amber,
 *      in which ca, os and NA are carbon, oxygen and nitrogen; numbers are no types of these: there the name counts.
 *   3. An ion has the name of its residue: an element's symbol, or a name of CHARMM: SOD, CLA, POT, CAL, CES ..
 *   4. In a known residue the element is the first letter of the name, which may follow digits; SE is selenium in MSE,
 *      SEC and CSE, and the metal that a cofactor has is one by its two letters: FE of HEM, MG of CLA, CO of B12. Amino
 *      acids and nucleotides have no boron, and sulfur only in CYS, MET and their kin and in place of oxygen of
 *      phosphates and sugars, S1P, S2P, S5'; else B and S are beads, BB, SC1.
 *      In amino acids A and X as first letters are unknown elements: AD1 or XD1 of ASX is nitrogen or oxygen, but not
 *      known which. Other names are virtual sites: EP, M, MW, LP, DU, DM1; in water OM; in amino acids Q and M as first
 *      letters and D before the name of a heavy atom.
 *   5. Elsewhere columns count: a symbol stands right-justified in the first two, so that "CA  " is calcium. Names of
 *      four characters have no room for that: hydrogens ("HG11", "DD21") begin in the first column, and so do others
 *      ("CL12", "CAA1"), where two letters are a symbol only if no third one follows.
 *   6. Then letters count: a small letter behind a capital is part of the symbol (Ar, Cl1). Two capitals are a symbol
 *      if they are no usual name of an atom of the first letter's element (CL, BR, FE, SI, PT, but not CO, CD or PB).
 *      Else the first letter is the element, if there is such an element. CLA to CLZ are carbons.
 *   Labels of crystals are read by rule 6; but Ow, Hn and Wat are of water and the like, and two capitals that may be
 *   either, CO1, tell nothing. */
bool atom_take_element(const struct atom_evidence *evidence, struct atom_label *label);

/* The last elements found, by name and residue, as the same few come again and again. Zeros at first. */
struct elements_seen {
  struct element_seen {
    uint64_t name, residue; /* eight characters each, with zeros behind */
    unsigned char length;   /* of the name; 0: nothing yet */
    bool virtual_site : 1, bead : 1, by_letters : 1;
    struct element_symbol element;
  } of[256];
};

/* The same for a name alone, with ATOM_NAMES. Eight characters of the name must be readable. */
void atom_take_element_again(struct elements_seen *seen, struct field name, struct atom_label *label);

/* Whether a stated symbol is that of a usual element and leaves nothing to look at, as nearly all do. */
static inline bool atom_is_usual(char symbol, const char *residue) {
  return (symbol == 'C' || symbol == 'N' || symbol == 'O' || symbol == 'H' || symbol == 'P') &&
         (to_upper(residue[0]) != 'D' || to_upper(residue[1]) != 'U'); /* of dummies, DUM */
}

/* If a residue has a hydrogen HL1, or carbons CLP or CLA, its atom CL whose element was guessed by letters is a carbon,
 * too. */
void molecule_agree_elements(struct molecule *molecule);
