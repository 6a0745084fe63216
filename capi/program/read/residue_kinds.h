/* The meaning of names of residues and atoms: which residues are known, and which element an atom is where no column
 * says so. */
#ifndef HARDSPHERE_TOOL_RESIDUE_KINDS_H
#define HARDSPHERE_TOOL_RESIDUE_KINDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/fields.h"
#include "read/radii.h"

enum residue_kind { RESIDUE_OTHER, RESIDUE_AMINO_ACID, RESIDUE_NUCLEOTIDE, RESIDUE_WATER };

/* The kind of the residue of that name, in any case of its letters: the 20 amino acids, their protonation states and
 * frequent modifications, caps of chains; nucleotides; water, by the names that its models go by. */
enum residue_kind residue_kind_of(const char *name);

enum atom_kind {
  ATOM_KNOWN,   /* *element is set */
  ATOM_UNKNOWN, /* the name does not tell; *element is empty */
  ATOM_BEAD,    /* no atom: several of them as one, as coarse-grained models have it */
  ATOM_VIRTUAL  /* no atom: a charge or a lone pair beside one, a Drude particle, a pseudo-atom */
};

/* The kind of an atom, by its name and its residue's:
 *   1. an ion, if both names have the same letters, those of an element or one of CHARMM's: SOD, CLA, POT, CAL, CES ..;
 *   2. in a known residue the element is the first letter of the name, which may follow digits; SE is selenium in MSE,
 *      SEC and CSE. Amino acids and nucleotides have no boron, and sulfur only in CYS, MET and their kin; else B and S
 *      are beads, BB, SC1. In amino acids A and X as first letters are unknown elements: AD1 or XD1 of ASX is nitrogen
 *      or oxygen, and nobody could tell which. Other names are virtual sites: EP, M, MW, LP; in water OM; in amino
 *      acids Q and M as first letters and D before the name of a heavy atom;
 *   3. elsewhere the name decides. In the columns of a PDB file, four characters, blanks included, a symbol stands
 *      right-justified in the first two: " CA " is carbon (the alpha carbon), "CA  " is calcium. A small letter behind
 *      a capital is part of its symbol in any columns (" Ar "). Names of four characters have no room for that:
 *      hydrogens ("HG11", "DD21") begin in the first column, and so do others ("CL12", "CAA1"), where two letters are a
 *      symbol only if no third one follows. Names without columns are one of Cl, Br, Fe, Zn, Mg and Se, or begin with
 *      an element of one letter.
 * Deuterium is hydrogen. */
enum atom_kind atom_kind_of(struct field name, bool in_columns, const char *residue, struct element_symbol *element);

/* The last findings for names and residues, by both: the same few come again and again. Zeros at first. */
struct kinds_seen {
  struct kind_seen {
    uint64_t name, residue; /* eight characters each, with zeros behind */
    unsigned char length;   /* of the name; 0: nothing yet */
    unsigned char kind;
    struct element_symbol element;
  } of[256];
};

/* The same as atom_kind_of without columns; eight characters may be read of the name, and zeros stand behind the
 * residue's. */
enum atom_kind atom_kind_again(struct kinds_seen *seen, struct field name, const char residue[8],
                               struct element_symbol *element);

/* Whether the name is one that beads have in such a residue, BB, BB1, SC1, whatever element programs guess from it. */
bool is_bead_name(const char *name, const char *residue);

/* Whether a symbol that no element has is one that programs write for virtual sites: EP, LP, M, MW. */
bool is_virtual_symbol(struct element_symbol symbol);

/* Such a symbol for the name of a virtual site; empty if there is none. */
struct element_symbol virtual_symbol_of(struct field name);

#endif
