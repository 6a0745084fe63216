/* One rule for the element of an atom, which every reader calls. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/characters.h"
#include "read/fields.h"
#include "read/molecule.h"

/* The meaning of names and symbols where they stand. */
enum atom_dialect {
  ATOM_NAMES,    /* .gro, .pqr, mmCIF, names of macromolecules: CA is an alpha carbon, X an atom that nobody knows */
  ATOM_COLUMNS,  /* .pdb: the same names in four columns, blanks included */
  ATOM_AUTODOCK, /* .pdbqt: those columns, and a type of AutoDock's */
  ATOM_LABELS,   /* .cif of crystals: a symbol, and what tells the sites apart */
  ATOM_SYMBOLS,  /* .xyz: a symbol or an atomic number; X is a dummy that an internal coordinate was defined by */
  ATOM_QUERIES,  /* .sdf: likewise, and A, Q, L, R.. are what a search may find there */
  ATOM_TYPES     /* .mol2: a type of SYBYL's or of a force field, beside a name */
};

/* The words of a file on an atom's element. Both may be empty. The residue is that of the label. */
struct atom_evidence {
  enum atom_dialect dialect;
  struct field name;   /* as written */
  struct field stated; /* a symbol, an atomic number or a type */
};

/* Tell the element of an atom of the labelled residue, or that it is no atom. False: what the file states is no such
 * thing, or neither that nor a label or name beside it tells. Of names alone the element stays empty then.
 *   1. A residue DUM has dummies, which are never atoms.
 *   2. A stated symbol counts. Deuterium and tritium are hydrogen. Symbols that no element has are dummies and virtual
 *      sites, Du, EP, LP, M, MW, in .xyz, .sdf and .mol2 files X as well, and in the last two what stands for no atom:
 *      *, A, Q, L, R1, R#, Pol. A type of SYBYL's begins with a symbol; types in small letters or two capitals are
 *      those of GAFF and Amber, in which ca, os and NA are carbon, oxygen and nitrogen, and numbers are none: there the
 *      name counts.
 *   3. An ion has the letters of its residue, those of an element or one of CHARMM's: SOD, CLA, POT, CAL, CES ..
 *   4. In a known residue the element is the first letter of the name, which may follow digits; SE is selenium in MSE,
 *      SEC and CSE, and the metal that a cofactor has is one by its two letters: FE of HEM, MG of CLA, CO of B12. Amino
 *      acids and nucleotides have no boron, and sulfur only in CYS, MET and their kin; else B and S are beads, BB, SC1.
 *      In amino acids A and X as first letters are unknown elements: AD1 or XD1 of ASX is nitrogen or oxygen, and
 *      nobody could tell which. Other names are virtual sites: EP, M, MW, LP, DU, DM1; in water OM; in amino acids Q
 *      and M as first letters and D before the name of a heavy atom.
 *   5. Elsewhere columns count: a symbol stands right-justified in the first two, so that "CA  " is calcium. Names of
 *      four characters have no room for that: hydrogens ("HG11", "DD21") begin in the first column, and so do others
 *      ("CL12", "CAA1"), where two letters are a symbol only if no third one follows.
 *   6. Then letters: a small one behind a capital is part of its symbol (Ar, Cl1); two capitals are, where these are
 *      no usual name of an atom of the first one (CL, BR, FE, SI, PT, but not CO, CD or PB); else the first letter is
 *      the element, if one has it. CLA to CLZ are carbons.
 *   Labels of crystals are letters of the last kind: but Ow, Hn and Wat are of water and its like, and two capitals
 *   that may be either, CO1, tell nothing. */
bool atom_take_element(const struct atom_evidence *evidence, struct atom_label *label);

/* The last findings for names and residues, by both: the same few come again and again. Zeros at first. */
struct elements_seen {
  struct element_seen {
    uint64_t name, residue; /* eight characters each, with zeros behind */
    unsigned char length;   /* of the name; 0: nothing yet */
    bool virtual_site : 1, bead : 1, by_letters : 1;
    struct element_symbol element;
  } of[256];
};

/* The same of a name alone, ATOM_NAMES. Eight characters may be read of it. */
void atom_take_element_again(struct elements_seen *seen, struct field name, struct atom_label *label);

/* Whether a stated symbol is that of a usual element and leaves nothing to look at, as nearly all do. */
static inline bool atom_is_usual(char symbol, const char *residue) {
  return (symbol == 'C' || symbol == 'N' || symbol == 'O' || symbol == 'H' || symbol == 'P') &&
         (to_upper(residue[0]) != 'D' || to_upper(residue[1]) != 'U'); /* of dummies, DUM */
}

/* Where a residue has a hydrogen HL1, or carbons CLP or CLA, an atom CL that only its letters tell is a carbon too. */
void molecule_agree_elements(struct molecule *molecule);
